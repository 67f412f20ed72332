import { type Material, Material as BaseMaterial, type ShaderMaterial, UniformsLib, type WebGLRenderer } from 'three';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind, TwinShader } from './TwinKind';
import { TwinRefusal } from '../three/TwinRefusal';

/** What twins of one renderer share. */
export interface TwinContext {
  /** Uniforms given to every twin, by reference. */
  readonly uniforms: Record<string, { value: unknown }>;
  /** Resolved microshader headers. */
  header(chunks: readonly string[]): string;
  /** Grows when a microshader of the list is replaced. */
  revision(chunks: readonly string[]): number;
  /** Differs where the texts of the chunks do, also from those of another renderer. */
  textKey(chunks: readonly string[]): string;
  /** Told of a source whose shader has no place for what a kind puts into it: its twin draws it by three's lights alone. */
  refuse(source: Material): void;
}

/** three's lights of Farol's frames, for shader materials whose uniforms are the source's: its own are of other frames. */
function ownLights(uniforms: TwinShader['uniforms']): TwinShader['uniforms'] {
  const own: TwinShader['uniforms'] = {};
  for (const name in UniformsLib.lights) if (name in uniforms) own[name] = { ...uniforms[name] };
  return own;
}

/**
 * A twin inherits every property of its source, live, and has programs of its own. Nothing is written to the source.
 */
export function createTwin(source: Material, kind: TwinKind, context: TwinContext): Material {
  const twin = Object.create(source) as Material;
  const chunks = kind.chunks(source);
  const own = (name: string, value: unknown) =>
    Object.defineProperty(twin, name, { value, writable: true, configurable: true, enumerable: true });
  Object.defineProperty(twin, 'id', { value: new BaseMaterial().id });
  Object.defineProperty(twin, 'version', {
    get: () => source.version + context.revision(chunks),
    // three's switch of sides on transparent materials must not reach the source; Frame draws the sides by twins
    set() {},
  });
  // three takes the flag down after a draw: Frame does so on the source, when its twin was drawn
  if ('uniformsNeedUpdate' in source) {
    Object.defineProperty(twin, 'uniformsNeedUpdate', {
      get: () => (source as ShaderMaterial).uniformsNeedUpdate,
      set() {},
    });
  }
  own('_listeners', undefined);
  own(
    'customProgramCacheKey',
    () =>
      `farol:${kind.key}:${kind.variant?.(source) ?? ''}:${context.textKey(chunks)}:${threeChunks.revision}:${source.customProgramCacheKey()}`,
  );
  own('onBeforeCompile', (shader: TwinShader, webgl: WebGLRenderer) => {
    source.onBeforeCompile(shader as Parameters<Material['onBeforeCompile']>[0], webgl);
    shader.uniforms = {
      ...shader.uniforms,
      ...ownLights(shader.uniforms),
      ...context.uniforms,
    } as TwinShader['uniforms'];
    const { vertexShader, fragmentShader } = shader;
    try {
      kind.patch(shader, source, context.header(chunks));
    } catch (error) {
      if (!(error instanceof TwinRefusal)) throw error;
      Object.assign(shader, { vertexShader, fragmentShader });
      context.refuse(source);
    }
  });
  // what a kind computes, it computes at each draw
  const properties = Object.getOwnPropertyDescriptors(kind.properties ?? {});
  for (const [name, descriptor] of Object.entries(properties)) {
    Object.defineProperty(twin, name, { ...descriptor, configurable: true });
  }
  return twin;
}
