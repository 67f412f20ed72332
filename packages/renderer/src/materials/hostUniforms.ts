import type { IUniform, Material, WebGLRenderer } from 'three';
import { compiledUniforms } from '../three/handles';

type Uniforms = Record<string, IUniform>;

/**
 * Uniforms that the page's `onBeforeCompile` has added, by material. A page keeps the shader object of the last call and sets
 * its uniforms: three draws all programs of the material with these, and so must all twins.
 */
const added = new WeakMap<Material, Uniforms>();
/** Entry of `added` whose uniforms stock three draws the material with. */
const followed = new WeakMap<Material, Uniforms>();

/**
 * @param before - uniforms of a twin's shader, as made by three
 * @param after - these uniforms after the page's callback
 * @returns uniforms of the twin: three's, with those of the page's last shader as prototype
 */
export function withHostUniforms(webgl: WebGLRenderer, source: Material, before: Uniforms, after: Uniforms): Uniforms {
  // uniforms of a ShaderMaterial belong to the page, which may replace them at any time
  if ('uniforms' in source) return Object.create(after) as Uniforms;
  let own = added.get(source);
  if (own === undefined) added.set(source, (own = {}));
  const uniforms = Object.create(own) as Uniforms;
  for (const name in after) {
    if (after[name] === before[name]) uniforms[name] = after[name];
    else own[name] = (compiledUniforms(webgl, source) ?? own)[name] = after[name];
  }
  return uniforms;
}

/** Makes `added` refer to the uniforms of stock three's program for a material, when three has compiled a new one. */
export function followHostUniforms(webgl: WebGLRenderer, source: Material): void {
  const stock = compiledUniforms(webgl, source);
  if (stock === undefined || stock === followed.get(source)) return;
  followed.set(source, stock);
  const own = added.get(source);
  for (const name in own) own[name] = stock[name];
}
