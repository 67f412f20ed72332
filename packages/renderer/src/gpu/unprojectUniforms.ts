import { Vector2, Vector4, type Camera, type IUniform, type PerspectiveCamera, type WebGLRenderer } from 'three';
import { isDepthReversed } from '../three/state';

/** Uniforms of the chunk `unproject`, which computes positions from depth. */
export interface UnprojectUniforms extends Record<string, IUniform> {
  farol_unprojectZ: IUniform<Vector4>;
  farol_unprojectXY: IUniform<Vector4>;
  farol_perspective: IUniform<number>;
  farol_depthMode: IUniform<Vector2>;
}

/** Makes the uniforms of the chunk `unproject`. */
export function unprojectUniforms(): UnprojectUniforms {
  return {
    farol_unprojectZ: { value: new Vector4() },
    farol_unprojectXY: { value: new Vector4() },
    farol_perspective: { value: 1 },
    farol_depthMode: { value: new Vector2() },
  };
}

/** Far plane of logarithmic depth (m); 0 if depth is not logarithmic. three uses it only with perspective projections. */
export function logarithmicFar(camera: Camera, webgl: WebGLRenderer): number {
  const { isPerspectiveCamera, far } = camera as PerspectiveCamera;
  return webgl.capabilities.logarithmicDepthBuffer && isPerspectiveCamera ? far : 0;
}

/** Sets the uniform of depthMode.glsl. */
export function setDepthMode({ value }: IUniform<Vector2>, camera: Camera, webgl: WebGLRenderer): void {
  value.set(isDepthReversed(webgl) ? 1 : 0, Math.log2(logarithmicFar(camera, webgl) + 1));
}

/** Sets the uniforms from the camera's projection, rounded to 32-bit floats, and the renderer's kind of depth. */
export function setUnprojectUniforms(uniforms: UnprojectUniforms, camera: Camera, webgl: WebGLRenderer): void {
  setDepthMode(uniforms.farol_depthMode, camera, webgl);
  const p = camera.projectionMatrix.elements;
  const z = Math.fround(p[10]);
  const t = Math.fround(p[14]);
  const perspective = p[11] !== 0;
  if (uniforms.farol_depthMode.value.x > 0) {
    // depth of view z `zv`, in perspective (z zv + t) / -zv = e, else z zv + t = e, solved for zv
    if (perspective) uniforms.farol_unprojectZ.value.set(-t, 0, z, 1);
    else uniforms.farol_unprojectZ.value.set(-t, 1, z, 0);
  } else if (perspective) {
    // (z zv + t) / -zv = 1 - 2e, solved for zv
    uniforms.farol_unprojectZ.value.set(-t, 0, 1 + z, -2);
  } else {
    // z zv + t = 1 - 2e, solved for zv
    uniforms.farol_unprojectZ.value.set(1 - t, -2, z, 0);
  }
  if (perspective) uniforms.farol_unprojectXY.value.set(1 / p[0], 1 / p[5], p[8], p[9]);
  else uniforms.farol_unprojectXY.value.set(1 / p[0], 1 / p[5], -p[12], -p[13]);
  uniforms.farol_perspective.value = perspective ? 1 : 0;
}
