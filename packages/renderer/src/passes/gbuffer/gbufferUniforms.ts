import { Vector2, type Camera, type IUniform, type OrthographicCamera } from 'three';
import type { Frame } from '../../frame/Frame';
import type { GBuffer } from '../../gbuffer/GBuffer';
import { gbufferTextureUniforms, type GBufferTextureUniforms, textureUniforms } from '../../gbuffer/gbufferNames';
import { setUnprojectUniforms, unprojectUniforms, type UnprojectUniforms } from '../../gpu/unprojectUniforms';

/** Uniforms of gbufferRead.glsl and viewport.glsl. */
export interface GBufferUniforms extends GBufferTextureUniforms, UnprojectUniforms {
  farol_gStored: IUniform<number[]>;
  /** Size of the picture (pixels). */
  farol_size: IUniform<Vector2>;
  farol_offset: IUniform<Vector2>;
}

/** Makes the uniforms of shaders that read the G-buffer; `setGBufferUniforms` sets them. */
export function gbufferUniforms(): GBufferUniforms {
  return {
    ...gbufferTextureUniforms(),
    farol_gStored: { value: [0, 0, 0] },
    ...unprojectUniforms(),
    farol_size: { value: new Vector2() },
    farol_offset: { value: new Vector2() },
  };
}

/** Kind of stored distance for a camera: 1 perspective, 2 orthographic. */
export function storedKind(camera: Camera): 1 | 2 {
  return (camera as OrthographicCamera).isOrthographicCamera === true ? 2 : 1;
}

/** Sets the uniforms for a G-buffer and this frame's camera and size. */
export function setGBufferUniforms(uniforms: GBufferUniforms, gbuffer: GBuffer, frame: Frame): void {
  for (let i = 0; i < textureUniforms.length; i++) uniforms[textureUniforms[i]].value = gbuffer.target.textures[i];
  uniforms.farol_gAccumulation.value = gbuffer.accumulation;
  uniforms.farol_gDepth.value = gbuffer.depth;
  const stored = uniforms.farol_gStored.value;
  stored[0] = gbuffer.storesDistance ? storedKind(frame.camera) : 0;
  stored[1] = frame.queue.reachesFar ? 1 : 0;
  stored[2] = gbuffer.isLite ? 1 : 0;
  setUnprojectUniforms(uniforms, frame.camera, frame.webgl);
  uniforms.farol_size.value.set(frame.width, frame.height);
  uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
}
