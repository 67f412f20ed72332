import type { Frame } from '../../frame/Frame';

/** Whether shaders have code for area lights, since a scene has had one. */
export function hasAreaLights(frame: Frame): boolean {
  return frame.uniforms.farol_ltc.value !== null;
}
