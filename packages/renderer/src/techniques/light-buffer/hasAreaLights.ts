import type { Frame } from '../../frame/Frame';

/** Whether shaders know area lights: a scene has had one. */
export function hasAreaLights(frame: Frame): boolean {
  return frame.uniforms.farol_ltc.value !== null;
}
