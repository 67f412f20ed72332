import type { FieldValue } from '@farol/engine/fields';
import dissolve from './dissolve.surface?raw';
import hologram from './hologram.surface?raw';
import plain from './plain.surface?raw';
import rust from './rust.surface?raw';
import moss from './moss.surface?raw';
import snow from './snow.surface?raw';
import water from './water.surface?raw';
import waves from './waves.surface?raw';

/** A built-in surface: its text, and values of the material made for it. */
export interface BuiltinSurface {
  /** Text of the surface; '' for a surface built from the thesis's chunks by `thesisSurface`. */
  readonly source: string;
  readonly material: Readonly<Record<string, FieldValue>>;
  /** Whether the surface moves vertices, so that a plane (four vertices) is replaced by a grid. */
  readonly needsGrid?: boolean;
}

/** Built-in surfaces, by the id of the action that adds one. */
export const builtinSurfaces = {
  waves: { source: waves, material: { kind: 'physical', colour: [0.02, 0.12, 0.2], roughness: 0.15 }, needsGrid: true },
  water: { source: water, material: { kind: 'physical', colour: [0.02, 0.12, 0.2], roughness: 0.08 }, needsGrid: true },
  snow: { source: snow, material: { kind: 'standard', colour: [0.22, 0.2, 0.18], roughness: 0.8 } },
  moss: { source: moss, material: { kind: 'standard', colour: [0.4, 0.38, 0.35], roughness: 0.85 } },
  dissolve: { source: dissolve, material: { kind: 'standard', colour: [0.35, 0.35, 0.38], doubleSided: true } },
  rust: { source: rust, material: { kind: 'standard', colour: [0.05, 0.25, 0.3], roughness: 0.35, metalness: 0.6 } },
  hologram: {
    source: hologram,
    material: { kind: 'standard', transparent: true, depthWrite: false, doubleSided: true },
  },
  directional: { source: '', material: { kind: 'basic' } },
  point: { source: '', material: { kind: 'basic' } },
  spot: { source: '', material: { kind: 'basic' } },
  plain: { source: plain, material: { kind: 'standard' } },
} as const satisfies Readonly<Record<string, BuiltinSurface>>;

export type BuiltinSurfaceName = keyof typeof builtinSurfaces;
