import type { FieldTable, FieldValue } from '@farol/engine/fields';

/** State of the viewer; all of it is in the URL. */
export interface ViewerState {
  /** Name of the shown scene: a key of the engine's `scenes`. */
  scene: string;
  /** Name of the technique that draws: a key of the renderer's `techniques`, or 'auto'. */
  technique: string;
  view: string;
  /** Quality of the renderer: 'auto', 'full' or 'lite'. */
  quality: string;
  /** Values of scene parameters, such as lights, n, m and seed; those of other scenes are kept unused. */
  parameters: Record<string, FieldValue>;
  /** Key of an anti-aliasing effect of the renderer's `effects`, or 'none'. */
  aa: string;
  /** Non-default switches and numbers of the effects besides anti-aliasing, by their names in `KnownNames.effects`. */
  effects: Record<string, FieldValue>;
  /** Whether the demo's decals are in the scene. */
  decals: boolean;
  /** Number of living particles, each of them a light; 0 for none. */
  particles: number;
  /** Number of rectangle lights added to the scene; 0 for none. */
  rectangles: number;
  /** Simulated time (s) at which the scene is stopped; null while it runs. */
  time: number | null;
  /** Size of the picture (CSS pixels); null follows the window. */
  width: number | null;
  height: number | null;
  /** Device pixels per CSS pixel; null for the screen's ratio, 2 at most. */
  dpr: number | null;
  /** Frame budget ('auto', 'on', 'off'), as the engine's scene setting `frameBudget`. */
  budget: string;
  /** Whether the menu is shown. */
  gui: boolean;
}

export interface KnownNames {
  scenes: Readonly<Record<string, { readonly parameters: FieldTable }>>;
  techniques: readonly string[];
  views: readonly string[];
  qualities: readonly string[];
  antialiasing: readonly string[];
  budgets: readonly string[];
  /** Fields of the switches and numbers of the effects besides anti-aliasing, by their names in addresses. */
  effects: FieldTable;
  /** State of a URL without parameters. */
  defaults: ViewerState;
}
