import type { FieldTable, FieldValue } from '@farol/engine/fields';

/** What the viewer shows. All of it stands in the URL. */
export interface ViewerState {
  /** Key of the engine's `scenes`. */
  scene: string;
  /** Key of the renderer's `techniques`, or 'auto'. */
  technique: string;
  view: string;
  /** Given values of parameters of scenes, such as lights, n, m and seed; those of other scenes are kept, unused. */
  parameters: Record<string, FieldValue>;
  /** Resolution of the Stanford dragon, where a scene shows one. */
  dragon: string;
  /** Key of an anti-aliasing effect of the renderer's `effects`, or 'none'. */
  aa: string;
  /** Given switches and numbers of effects that smooth no edges, by their names in `KnownNames.effects`. */
  effects: Record<string, FieldValue>;
  /** Whether decals are thrown on the scene, to be looked at. */
  decals: boolean;
  /** Particles that live at once, each of them a light; 0 for none. */
  particles: number;
  /** Rectangle lights put into the scene; 0 for none. */
  rectangles: number;
  /** Fixed simulated time (s), drawn once and not moving; null lets it run. */
  time: number | null;
  /** Size of the picture (CSS pixels); null follows the window. */
  width: number | null;
  height: number | null;
  /** Device pixels a CSS pixel; null takes the screen's, 2 at most. */
  dpr: number | null;
  /** Whether the menu is shown. */
  gui: boolean;
}

/** What a state may name. */
export interface KnownNames {
  scenes: Readonly<Record<string, { readonly parameters: FieldTable }>>;
  techniques: readonly string[];
  views: readonly string[];
  dragons: readonly string[];
  antialiasing: readonly string[];
  /** Switches and numbers of the other effects, by their names in addresses. */
  effects: FieldTable;
  /** State of a URL without parameters. */
  defaults: ViewerState;
}
