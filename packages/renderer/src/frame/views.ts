/** Values of `FarolRenderer.view`. */
export const views = [
  'final',
  'albedo',
  'normal',
  'depth',
  'position',
  'roughness',
  'metalness',
  'emissive',
  'lighting',
  'light-count',
  'overdraw',
  'grid',
] as const;

export type View = (typeof views)[number];

/** Views that the technique draws by itself. */
export function isTechniqueView(view: View): boolean {
  return view === 'final' || view === 'lighting' || view === 'light-count';
}

/** Views in which the technique counts its work in place of shading. */
export function isCountView(view: View): boolean {
  return view === 'light-count' || view === 'overdraw';
}

/** Views of the surface itself, the same in every technique: drawn from a G-buffer of their own. */
export function isSurfaceView(view: View): boolean {
  return view !== 'final' && view !== 'lighting' && view !== 'grid' && !isCountView(view);
}
