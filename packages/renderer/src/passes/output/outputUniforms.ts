import { Color, type Texture } from 'three';

/** Values of `farol_view` in the output shaders: the picture, the light alone, or counts. */
export const OUTPUT_FINAL = 0;
export const OUTPUT_LIGHTING = 1;
export const OUTPUT_COUNTS = 2;

/** Makes the uniforms of all output shaders; three sets those of fog for materials with `fog`. */
export function outputUniforms() {
  return {
    fogColor: { value: new Color() },
    fogDensity: { value: 0 },
    fogNear: { value: 0 },
    fogFar: { value: 0 },
    farol_view: { value: OUTPUT_FINAL },
    farol_overdrawMap: { value: null as Texture | null },
  };
}

export type OutputUniforms = ReturnType<typeof outputUniforms>;
