import {
  type Material,
  Material as BaseMaterial,
  type MeshPhongMaterial,
  type ShaderMaterial,
  UniformsLib,
  type WebGLRenderer,
} from 'three';
import { withHostUniforms } from './hostUniforms';
import type { MicroShaderRegistry } from '../microshaders';
import { shadingOf } from './shadingOf';
import { inFullPrecision } from '../three/inFullPrecision';
import { standInOf } from '../three/standInOf';
import { surfacesOf } from './surfacesOf';
import { threeChunks } from '../three/ThreeChunks';
import type { TwinKind, TwinShader } from './TwinKind';
import { TwinRefusal } from '../three/TwinRefusal';

export interface TwinContext {
  /** Uniforms given to every twin, by reference. */
  readonly uniforms: Record<string, { value: unknown }>;
  /** Microshaders of the renderer. */
  readonly microshaders: Pick<MicroShaderRegistry, 'header' | 'revision' | 'textKey'>;
  /** Called for a source in whose shader a kind's patch cannot be inserted: its twin is lit only by three. */
  refuse(source: Material): void;
}

/** Replaces three's light uniforms, for shader materials that share their uniforms object with the source. */
function ownLights(uniforms: TwinShader['uniforms']): TwinShader['uniforms'] {
  const own: TwinShader['uniforms'] = {};
  for (const name in UniformsLib.lights) if (name in uniforms) own[name] = { ...uniforms[name] };
  return own;
}

const NOTHING = () => undefined;

/** Makes a twin: inherits every property of its source, live, and has its own programs. Writes nothing to the source. */
export function createTwin(source: Material, kind: TwinKind, context: TwinContext): Material {
  const twin = standInOf(source, BaseMaterial.prototype);
  const chunks = kind.chunks(source);
  const registry = context.microshaders as MicroShaderRegistry;
  const version = () =>
    source.version +
    registry.revision(chunks) +
    (surfacesOf(source)?.version(registry) ?? 0) +
    // a fraction, so that it differs from all versions of the source
    (shadingOf(source) === 'flat' ? 0.5 : 0);
  const customProgramCacheKey = () =>
    `farol:${kind.key}:${kind.variant?.(source) ?? ''}:${registry.textKey(chunks)}:${threeChunks.revision}:${surfacesOf(source)?.key(registry) ?? ''}:${source.customProgramCacheKey()}`;
  const onBeforeCompile = (shader: TwinShader, webgl: WebGLRenderer) => {
    // the page may have changed three's chunks for this material, which three compiles now
    threeChunks.follow();
    const before = { ...shader.uniforms };
    source.onBeforeCompile(shader as Parameters<Material['onBeforeCompile']>[0], webgl);
    const { uniforms } = shader;
    shader.uniforms = Object.assign(
      withHostUniforms(webgl, source, before, uniforms),
      ownLights(uniforms),
      context.uniforms,
    ) as TwinShader['uniforms'];
    surfacesOf(source)?.rewrite(shader, registry, webgl);
    const { vertexShader, fragmentShader } = shader;
    try {
      kind.patch(shader, source, inFullPrecision(registry.header(chunks)));
    } catch (error) {
      if (!(error instanceof TwinRefusal)) throw error;
      Object.assign(shader, { vertexShader, fragmentShader });
      context.refuse(source);
    }
  };
  return Object.defineProperties(twin, {
    id: { value: new BaseMaterial().id },
    // three switches the side of transparent materials, which must not change the source; Frame draws both sides by twins
    version: { get: version, set: NOTHING },
    // three resets `uniformsNeedUpdate` after a draw; Frame resets that of the source once its twin is drawn
    ...('uniformsNeedUpdate' in source && {
      uniformsNeedUpdate: { get: () => (source as ShaderMaterial).uniformsNeedUpdate, set: NOTHING },
    }),
    flatShading: { get: () => shadingOf(source) === 'flat' || (source as MeshPhongMaterial).flatShading },
    _listeners: { value: undefined, writable: true },
    // the source frees its own resources
    dispose: { value: BaseMaterial.prototype.dispose },
    customProgramCacheKey: { value: customProgramCacheKey },
    onBeforeCompile: { value: onBeforeCompile },
    // accessors of a kind's properties are evaluated at each draw
    ...Object.getOwnPropertyDescriptors(kind.properties ?? {}),
  });
}
