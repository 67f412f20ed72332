import { type Texture, Vector2, Vector4 } from 'three';
import { lightUniforms } from '../lighting/lightUniforms';
import { gridUniforms } from '../lighting/lists/gridUniforms';
import { tileUniforms } from '../lighting/lists/tileUniforms';
import { maskUniforms } from '../lighting/maskUniforms';

/** Uniforms that all twins and passes of one renderer share, by reference. */
export type SharedUniforms = ReturnType<typeof sharedUniforms>;

/** @param ambient - irradiance of ambient light, as in `VisibleLights.ambient`, 4 × RGB */
export function sharedUniforms(ambient: Float32Array) {
  return {
    farol_heatScale: { value: 1 / 32 },
    farol_lite: { value: false },
    /** Colour that three would clear to, in the target's encoding; alpha -1 if three has cleared. */
    farol_background: { value: new Vector4(0, 0, 0, -1) },
    /** Size of the picture (pixels), for frameSize.glsl. */
    farol_frameSize: { value: new Vector2(1, 1) },
    /** Light that fog scatters to the eye, and transmittance, as a 3D texture by pixel and slice; for mediaOn.glsl. */
    farol_media: { value: null as Texture | null },
    /** Two vectors: first pixel and 1 / size of the picture; scales and number of the slices, and 1 if there is fog. */
    farol_mediaSpace: { value: new Float32Array(8) },
    ...lightUniforms(ambient),
    ...maskUniforms(),
    ...tileUniforms(),
    ...gridUniforms(),
  };
}
