/**
 * Values of `FarolRenderer.view`. Those after 'grid' show a buffer of an effect, a technique or lights; if the frame lacks it,
 * the final picture is shown, and `FarolInfo.view` says what to change.
 */
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
  'ambient-occlusion',
  'motion',
  'reactive-mask',
  'light-buffer',
  'shadow-atlas',
  'image-atlas',
  'fog-light',
  'fog-transmittance',
  'froxels',
] as const;

/** Names of the views: the final picture, or an intermediate buffer or count. */
export type View = (typeof views)[number];

/** Whether the technique itself draws a view. */
export function isTechniqueView(view: View): boolean {
  return view === 'final' || view === 'lighting' || view === 'light-count';
}

/** Whether the technique counts its work in a view, in place of shading. */
export function isCountView(view: View): boolean {
  return view === 'light-count' || view === 'overdraw';
}

/** Whether a view shows surface properties, equal in every technique: drawn from a separate G-buffer. */
export function isSurfaceView(view: View): boolean {
  const index = views.indexOf(view);
  return index > 0 && index < views.indexOf('lighting');
}

/** Whether a view is drawn over the finished picture, since it shows a buffer of that frame. */
export function isBufferView(view: View): boolean {
  return views.indexOf(view) > views.indexOf('grid');
}
