import { RGBAFormat, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { gridShift } from './gridFit';
import type { LightBufferUniforms } from '../../frame/LightBuffer';
import type { ThinGBuffer, ThinGBufferUniforms } from '../../frame/ThinGBuffer';
import { storedKind } from '../../passes/gbuffer/gbufferUniforms';
import { setUnprojectUniforms } from '../../gpu/unprojectUniforms';

/** Sets the uniforms for a thin G-buffer and this frame's camera. */
export function setThinGBufferUniforms(uniforms: ThinGBufferUniforms, source: ThinGBuffer, frame: Frame): void {
  const { target } = source;
  uniforms.farol_thinSurface.value = target.texture;
  const distances = target.textures[1];
  uniforms.farol_thinDepth.value = distances ?? target.depthTexture;
  uniforms.farol_thinStored.value =
    distances === undefined ? 0 : storedKind(frame.camera) + (distances.format === RGBAFormat ? 4 : 0);
  uniforms.farol_size.value.set(target.viewport.z, target.viewport.w);
  setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
  const { x, y, z, w } = source.fit;
  uniforms.farol_fit.value.set(x, y, z, w);
  const unproject = uniforms.farol_unprojectXY.value;
  unproject.set(unproject.x / x, unproject.y / y, unproject.z * x - z, unproject.w * y - w);
}

/** Sets the uniforms for a thin G-buffer and its light buffer. @param sums - the textures of the light buffer */
export function setLightBufferUniforms(
  uniforms: LightBufferUniforms,
  source: ThinGBuffer,
  sums: readonly Texture[],
  frame: Frame,
): void {
  setThinGBufferUniforms(uniforms, source, frame);
  uniforms.farol_sums0.value = sums[0];
  uniforms.farol_sums1.value = sums[1];
  uniforms.farol_sums2.value = sums[2];
  uniforms.farol_sums3.value = sums[3] ?? null;
  const { scale } = source;
  const shift = gridShift(scale);
  uniforms.farol_lightGrid.value.set(scale, scale, frame.viewport.x - shift, frame.viewport.y - shift);
}
