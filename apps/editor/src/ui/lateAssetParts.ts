import { lateComponent } from './lateComponent';

/** A `PolarCurve` whose code is fetched when first needed. */
export const LatePolarCurve = lateComponent(async () => (await import('./PolarCurve')).PolarCurve);

/** A `SoundButton` whose code is fetched when first needed. */
export const LateSoundButton = lateComponent(async () => (await import('./SoundButton')).SoundButton);
