import type { IUniform, Light, Material, RenderTarget, Texture, WebGLRenderer } from 'three';

// Entries of three's WebGLProperties for textures, targets and materials; lost when a lost context is restored.

interface TextureProperties {
  readonly __webglTexture?: WebGLTexture;
}

interface TargetProperties {
  readonly __webglFramebuffer?: WebGLFramebuffer;
  readonly __webglMultisampledFramebuffer?: WebGLFramebuffer;
}

interface MaterialProperties {
  readonly __version?: number;
  readonly currentProgram?: { readonly program: WebGLProgram };
  light?: Light;
  readonly uniforms?: Record<string, IUniform>;
}

/** The WebGL texture; undefined until three first uses the texture. */
export function textureHandle(webgl: WebGLRenderer, texture: Texture): WebGLTexture | undefined {
  return (webgl.properties.get(texture) as TextureProperties).__webglTexture;
}

/**
 * Framebuffer of a target other than a cube; for a multisampled target, the one it is resolved to; undefined before the first
 * use.
 */
export function framebufferHandle(webgl: WebGLRenderer, target: RenderTarget): WebGLFramebuffer | undefined {
  return (webgl.properties.get(target) as TargetProperties).__webglFramebuffer;
}

/** Multisampled framebuffer of a target; undefined if the target is not multisampled. */
export function multisampledFramebufferHandle(
  webgl: WebGLRenderer,
  target: RenderTarget,
): WebGLFramebuffer | undefined {
  return (webgl.properties.get(target) as TargetProperties).__webglMultisampledFramebuffer;
}

/** Whether three has compiled a program for a material's current version. */
export function isCompiled(webgl: WebGLRenderer, material: Material): boolean {
  return (webgl.properties.get(material) as MaterialProperties).__version === material.version;
}

/** Uniforms of a material's draws, from its program compiled last; undefined before the first. */
export function compiledUniforms(webgl: WebGLRenderer, material: Material): Record<string, IUniform> | undefined {
  return (webgl.properties.get(material) as MaterialProperties).uniforms;
}

export function programHandle(webgl: WebGLRenderer, material: Material): WebGLProgram {
  return (webgl.properties.get(material) as MaterialProperties).currentProgram!.program;
}

/** Tells three's MeshDistanceMaterial which light its distances are from. */
export function setLightOf(webgl: WebGLRenderer, material: Material, light: Light): void {
  (webgl.properties.get(material) as MaterialProperties).light = light;
}
