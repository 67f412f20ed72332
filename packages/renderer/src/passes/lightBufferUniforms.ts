import { Vector2, Vector4, type IUniform, type Texture } from 'three';
import type { Frame } from '../Frame';
import type { LightBufferPass } from './LightBufferPass';
import type { ThinGBufferPass } from './ThinGBufferPass';
import { setUnprojectUniforms, unprojectUniforms, type UnprojectUniforms } from './unprojectUniforms';

/** Uniforms of thinGBufferRead.glsl. */
export interface ThinGBufferUniforms extends UnprojectUniforms {
  farol_thinSurface: IUniform<Texture | null>;
  farol_thinDepth: IUniform<Texture | null>;
  /** Texels. */
  farol_size: IUniform<Vector2>;
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
    farol_size: { value: new Vector2() },
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

export function setThinGBufferUniforms(uniforms: ThinGBufferUniforms, source: ThinGBufferPass, frame: Frame): void {
  const target = source.target!;
  uniforms.farol_thinSurface.value = target.texture;
  uniforms.farol_thinDepth.value = target.depthTexture;
  uniforms.farol_size.value.set(target.width, target.height);
  setUnprojectUniforms(uniforms, frame.camera);
  const offset = uniforms.farol_unprojectXY.value;
  offset.z -= source.shift.value.x;
  offset.w -= source.shift.value.y;
}

export function setLightBufferUniforms(
  uniforms: LightBufferUniforms,
  source: ThinGBufferPass,
  lights: LightBufferPass,
  frame: Frame,
): void {
  setThinGBufferUniforms(uniforms, source, frame);
  const { textures, width, height } = lights.target!;
  uniforms.farol_sums0.value = textures[0];
  uniforms.farol_sums1.value = textures[1];
  uniforms.farol_sums2.value = textures[2];
  const { viewport } = frame;
  const { x, y } = source.shift.value;
  const left = viewport.x - x * 0.5 * frame.width;
  const bottom = viewport.y - y * 0.5 * frame.height;
  uniforms.farol_lightGrid.value.set(width / frame.width, height / frame.height, left, bottom);
}
