import type { FieldTable, FieldValue } from '@farol/engine/fields';

/** State of the viewer, all of it in the URL. */
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
  /** Given switches and numbers of effects that smooth no edges, by their names in `KnownNames.effects`. */
  effects: Record<string, FieldValue>;
  /** Whether the scene has the decals of the demo. */
  decals: boolean;
  /** Particles that live at once, each of them a light; 0 for none. */
  particles: number;
  /** Rectangle lights put into the scene; 0 for none. */
  rectangles: number;
  /** Simulated time (s) at which the scene stands still; null while it moves. */
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
  /** Switches and numbers of the other effects, by their names in addresses. */
  effects: FieldTable;
  /** State of a URL without parameters. */
  defaults: ViewerState;
}
