import { Color, type IUniform } from 'three';

/** The fog uniforms of three, which its renderer fills for materials with `fog`. */
export function fogUniforms(): Record<string, IUniform> {
  return {
    fogColor: { value: new Color() },
    fogDensity: { value: 0 },
    fogNear: { value: 0 },
    fogFar: { value: 0 },
  };
}

/** `farol_view` of deferredOutput.glsl and accumulatedOutput.glsl. */
export const OUTPUT_FINAL = 0;
export const OUTPUT_LIGHTING = 1;
export const OUTPUT_COUNTS = 2;
