import type { IUniform, Light, Material, RenderTarget, Texture, WebGLRenderer } from 'three';

// What three's WebGLProperties keeps of textures, targets and materials. All of it is gone once a lost context is restored.

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

/** The framebuffer of a target that is no cube, of several samples a pixel the one they are resolved to; undefined until it is used. */
export function framebufferHandle(webgl: WebGLRenderer, target: RenderTarget): WebGLFramebuffer | undefined {
  return (webgl.properties.get(target) as TargetProperties).__webglFramebuffer;
}

/** The framebuffer of several samples a pixel; undefined where the target has none. */
export function multisampledFramebufferHandle(
  webgl: WebGLRenderer,
  target: RenderTarget,
): WebGLFramebuffer | undefined {
  return (webgl.properties.get(target) as TargetProperties).__webglMultisampledFramebuffer;
}

/** Whether three has a program of a material's present version. */
export function isCompiled(webgl: WebGLRenderer, material: Material): boolean {
  return (webgl.properties.get(material) as MaterialProperties).__version === material.version;
}

/** The uniforms that a material is drawn with, whatever its program: of the one that was compiled last; undefined before. */
export function compiledUniforms(webgl: WebGLRenderer, material: Material): Record<string, IUniform> | undefined {
  return (webgl.properties.get(material) as MaterialProperties).uniforms;
}

/** The program that a material was last drawn with. */
export function programHandle(webgl: WebGLRenderer, material: Material): WebGLProgram {
  return (webgl.properties.get(material) as MaterialProperties).currentProgram!.program;
}

/** Tells three's MeshDistanceMaterial which light its distances are from. */
export function setLightOf(webgl: WebGLRenderer, material: Material, light: Light): void {
  (webgl.properties.get(material) as MaterialProperties).light = light;
}
