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
  /** Called for a source whose shader has no place for a kind's patch: its twin draws by three's lights alone. */
  refuse(source: Material): void;
}

/**
 * Replaces three's light uniforms by those of Farol's frames, for shader materials that share the source's uniforms.
 */
function ownLights(uniforms: TwinShader['uniforms']): TwinShader['uniforms'] {
  const own: TwinShader['uniforms'] = {};
  for (const name in UniformsLib.lights) if (name in uniforms) own[name] = { ...uniforms[name] };
  return own;
}

const NOTHING = () => undefined;

/**
 * A twin inherits every property of its source, live, and has programs of its own. Nothing is written to the source.
 */
export function createTwin(source: Material, kind: TwinKind, context: TwinContext): Material {
  const twin = standInOf(source, BaseMaterial.prototype);
  const chunks = kind.chunks(source);
  const registry = context.microshaders as MicroShaderRegistry;
  const version = () =>
    source.version +
    registry.revision(chunks) +
    (surfacesOf(source)?.version(registry) ?? 0) +
    // fraction, so that it lies between two versions of the source
    (shadingOf(source) === 'flat' ? 0.5 : 0);
  const customProgramCacheKey = () =>
    `farol:${kind.key}:${kind.variant?.(source) ?? ''}:${registry.textKey(chunks)}:${threeChunks.revision}:${surfacesOf(source)?.key(registry) ?? ''}:${source.customProgramCacheKey()}`;
  const onBeforeCompile = (shader: TwinShader, webgl: WebGLRenderer) => {
    // the page may have changed shaders for this material, which three takes up now
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
    // three's switch of sides on transparent materials must not reach the source; Frame draws the sides by twins
    version: { get: version, set: NOTHING },
    // three takes the flag down after a draw: Frame does so on the source, when its twin was drawn
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
