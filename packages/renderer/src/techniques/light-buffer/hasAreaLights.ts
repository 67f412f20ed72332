import type { Frame } from '../../frame/Frame';

/** Whether shaders contain code for area lights, which they do after the first scene with one. */
export function hasAreaLights(frame: Frame): boolean {
  return frame.uniforms.farol_ltc.value !== null;
}
