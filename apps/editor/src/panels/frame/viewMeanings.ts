import { t } from '@farol/editing';
import type { View } from '@farol/renderer';

/** Explanations of the debug views that show buffers, in whole sentences. */
export const viewMeanings: { readonly [Name in View]?: () => string } = {
  'ambient-occlusion': () => t('Share of the sky that is open over each pixel: white is all of it.'),
  motion: () => t('Motion of each pixel since the last frame: colour is direction, brightness length.'),
  'reactive-mask': () => t('Pixels whose history TAA ignores, since particles cover them.'),
  'light-buffer': () => t('Sums of light on each pixel, before materials give them their colours.'),
  'shadow-atlas': () => t('Shadow maps of all lights as they lie in one texture: near is black, far white.'),
  'image-atlas': () => t('Images and profiles of lights as they lie in one texture.'),
  'fog-light': () => t('Light that fog sends to the eye, from what lies before each surface.'),
  'fog-transmittance': () =>
    t('Share of light that fog lets through from each surface to the eye: white is all of it.'),
  froxels: () => t('Light in the fog, slice by slice: from the eye (upper left) to where the fog ends.'),
};
