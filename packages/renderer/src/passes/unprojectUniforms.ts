import { Vector4, type Camera, type IUniform } from 'three';

/** Uniforms of unproject.glsl. */
export interface UnprojectUniforms extends Record<string, IUniform> {
  farol_unprojectZ: IUniform<Vector4>;
  farol_unprojectXY: IUniform<Vector4>;
  farol_perspective: IUniform<number>;
}

export function unprojectUniforms(): UnprojectUniforms {
  return {
    farol_unprojectZ: { value: new Vector4() },
    farol_unprojectXY: { value: new Vector4() },
    farol_perspective: { value: 1 },
  };
}

/** Takes the camera's projection, rounded as the GPU sees it. */
export function setUnprojectUniforms(uniforms: UnprojectUniforms, camera: Camera): void {
  const p = camera.projectionMatrix.elements;
  const z = Math.fround(p[10]);
  const t = Math.fround(p[14]);
  const perspective = p[11] !== 0;
  if (perspective) {
    // (z zv + t) / -zv = 1 - 2e
    uniforms.farol_unprojectZ.value.set(-t, 0, 1 + z, -2);
    uniforms.farol_unprojectXY.value.set(1 / p[0], 1 / p[5], p[8], p[9]);
  } else {
    // z zv + t = 1 - 2e
    uniforms.farol_unprojectZ.value.set(1 - t, -2, z, 0);
    uniforms.farol_unprojectXY.value.set(1 / p[0], 1 / p[5], -p[12], -p[13]);
  }
  uniforms.farol_perspective.value = perspective ? 1 : 0;
}
