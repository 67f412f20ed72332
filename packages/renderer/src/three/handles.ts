import type { RenderTarget, Texture, WebGLRenderer } from 'three';

/** What three keeps of a texture, by `WebGLProperties`. */
interface TextureProperties {
  readonly __webglTexture?: WebGLTexture;
}

/** What three keeps of a target, by `WebGLProperties`. */
interface TargetProperties {
  readonly __webglFramebuffer?: WebGLFramebuffer;
  readonly __webglMultisampledFramebuffer?: WebGLFramebuffer;
}

/** three's WebGL texture; undefined until it is first used, and again once a lost context is restored. */
export function textureHandle(webgl: WebGLRenderer, texture: Texture): WebGLTexture | undefined {
  return (webgl.properties.get(texture) as TextureProperties).__webglTexture;
}

/** three's framebuffer of a target that is no cube, the one that holds single samples; undefined until it is first used. */
export function framebufferHandle(webgl: WebGLRenderer, target: RenderTarget): WebGLFramebuffer | undefined {
  return (webgl.properties.get(target) as TargetProperties).__webglFramebuffer;
}

/** three's framebuffer of several samples a pixel; undefined where the target has none. */
export function multisampledFramebufferHandle(
  webgl: WebGLRenderer,
  target: RenderTarget,
): WebGLFramebuffer | undefined {
  return (webgl.properties.get(target) as TargetProperties).__webglMultisampledFramebuffer;
}
