import {
  type Material,
  Material as BaseMaterial,
  type MeshPhongMaterial,
  type ShaderMaterial,
  UniformsLib,
  type WebGLRenderer,
} from 'three';
import type { MicroShaderRegistry } from '../microshaders';
import { shadingOf } from './shadingOf';
import { inFullPrecision } from '../three/inFullPrecision';
import { surfacesOf } from './surfacesOf';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind, TwinShader } from './TwinKind';
import { TwinRefusal } from '../three/TwinRefusal';

/** What twins of one renderer share. */
export interface TwinContext {
  /** Uniforms given to every twin, by reference. */
  readonly uniforms: Record<string, { value: unknown }>;
  /** The registry of the renderer. */
  readonly microshaders: Pick<MicroShaderRegistry, 'header' | 'revision' | 'textKey'>;
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
  const registry = context.microshaders as MicroShaderRegistry;
  const own = (name: string, value: unknown) =>
    Object.defineProperty(twin, name, { value, writable: true, configurable: true, enumerable: true });
  Object.defineProperty(twin, 'id', { value: new BaseMaterial().id });
  Object.defineProperty(twin, 'version', {
    get: () =>
      source.version +
      registry.revision(chunks) +
      (surfacesOf(source)?.version(registry) ?? 0) +
      // between two versions of the source
      (shadingOf(source) === 'flat' ? 0.5 : 0),
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
  Object.defineProperty(twin, 'flatShading', {
    get: () => shadingOf(source) === 'flat' || (source as MeshPhongMaterial).flatShading,
  });
  own('_listeners', undefined);
  own(
    'customProgramCacheKey',
    () =>
      `farol:${kind.key}:${kind.variant?.(source) ?? ''}:${registry.textKey(chunks)}:${threeChunks.revision}:${surfacesOf(source)?.key(registry) ?? ''}:${source.customProgramCacheKey()}`,
  );
  own('onBeforeCompile', (shader: TwinShader, webgl: WebGLRenderer) => {
    source.onBeforeCompile(shader as Parameters<Material['onBeforeCompile']>[0], webgl);
    shader.uniforms = {
      ...shader.uniforms,
      ...ownLights(shader.uniforms),
      ...context.uniforms,
    } as TwinShader['uniforms'];
    surfacesOf(source)?.rewrite(shader, registry, webgl);
    const { vertexShader, fragmentShader } = shader;
    try {
      kind.patch(shader, source, inFullPrecision(registry.header(chunks)));
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
