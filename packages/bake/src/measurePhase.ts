/** Parts of a bake that are timed. */
export type Phase = 'unwrap' | 'merge' | 'bvh' | 'tables' | 'trace' | 'filter' | 'probes' | 'read' | 'stitch';

/**
 * Adds a phase of a bake to the browser's performance timeline, as `farol-bake unwrap`.
 *
 * @param begin - `performance.now()` at the beginning (ms); the phase ends now
 * @param detail - data attached to the entry
 */
export function measurePhase(phase: Phase, begin: number, detail?: unknown): void {
  performance.measure(`farol-bake ${phase}`, { start: begin, detail });
}
