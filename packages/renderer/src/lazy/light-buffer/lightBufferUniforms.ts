import { Vector2, Vector4, type IUniform, type Texture } from 'three';
import type { Frame } from '../../frame/Frame';
import { gridShift } from './gridFit';
import type { ThinGBuffer } from './ThinGBuffer';
import { storedKind } from '../../gbuffer/gbufferUniforms';
import { setUnprojectUniforms, unprojectUniforms, type UnprojectUniforms } from '../../gpu/unprojectUniforms';

/** Uniforms of thinGBufferRead.glsl. */
export interface ThinGBufferUniforms extends UnprojectUniforms {
  farol_thinSurface: IUniform<Texture | null>;
  farol_thinDepth: IUniform<Texture | null>;
  farol_thinStored: IUniform<number>;
  /** Texels. */
  farol_size: IUniform<Vector2>;
  /** From the picture's normalised device coordinates to the buffer's. */
  farol_fit: IUniform<Vector4>;
}

/** Uniforms of lightBufferFilter.glsl and lightBufferCounts.glsl. */
export interface LightBufferUniforms extends ThinGBufferUniforms {
  farol_sums0: IUniform<Texture | null>;
  farol_sums1: IUniform<Texture | null>;
  farol_sums2: IUniform<Texture | null>;
  farol_lightGrid: IUniform<Vector4>;
}

export function thinGBufferUniforms(): ThinGBufferUniforms {
  return {
    ...unprojectUniforms(),
    farol_thinSurface: { value: null },
    farol_thinDepth: { value: null },
    farol_thinStored: { value: 0 },
    farol_size: { value: new Vector2() },
    farol_fit: { value: new Vector4() },
  };
}

export function lightBufferUniforms(): LightBufferUniforms {
  return {
    ...thinGBufferUniforms(),
    farol_sums0: { value: null },
    farol_sums1: { value: null },
    farol_sums2: { value: null },
    farol_lightGrid: { value: new Vector4() },
  };
}

export function setThinGBufferUniforms(uniforms: ThinGBufferUniforms, source: ThinGBuffer, frame: Frame): void {
  const { target } = source;
  uniforms.farol_thinSurface.value = target.texture;
  const distances = target.textures[1];
  uniforms.farol_thinDepth.value = distances ?? target.depthTexture;
  uniforms.farol_thinStored.value = distances === undefined ? 0 : storedKind(frame.camera);
  uniforms.farol_size.value.set(target.width, target.height);
  setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
  const { x, y, z, w } = source.fit;
  uniforms.farol_fit.value.set(x, y, z, w);
  const unproject = uniforms.farol_unprojectXY.value;
  unproject.set(unproject.x / x, unproject.y / y, unproject.z * x - z, unproject.w * y - w);
}

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
  const { scale } = source;
  const shift = gridShift(scale);
  uniforms.farol_lightGrid.value.set(scale, scale, frame.viewport.x - shift, frame.viewport.y - shift);
}
