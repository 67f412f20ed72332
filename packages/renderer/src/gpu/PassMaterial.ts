import { GLSL3, RawShaderMaterial, ShaderMaterial, type IUniform, type ShaderMaterialParameters } from 'three';
import type { MicroShaderRegistry } from '../microshaders';
import { FULL_PRECISION } from '../three/inFullPrecision';
import { threeChunks } from '../three/ThreeChunks';

/** Options of the constructor of PassMaterial. */
export interface PassMaterialOptions extends Pick<
  ShaderMaterialParameters,
  | 'transparent'
  | 'blending'
  | 'blendSrc'
  | 'blendDst'
  | 'blendEquation'
  | 'colorWrite'
  | 'premultipliedAlpha'
  | 'depthTest'
  | 'depthWrite'
  | 'depthFunc'
  | 'side'
  | 'fog'
  | 'toneMapped'
  | 'defines'
> {
  readonly name: string;
  /** Microshaders whose mains form the vertex shader. */
  readonly vertex: readonly string[];
  /** Microshaders whose mains form the fragment shader. */
  readonly fragment: readonly string[];
  readonly uniforms: Record<string, IUniform>;
}

const PRECISION = `${FULL_PRECISION}precision highp sampler2D;\nprecision highp usampler2D;\n`;
// three's chunks are written for GLSL 1: these macros replace its names by those of GLSL 3
const GLSL1_NAMES = '#define texture2D texture\n#define varying in\n';

/** Material whose `version` counts changes of three's chunks too. */
interface Versioned {
  /** Number of changes of the material, without those of three's chunks. */
  ownVersion: number;
}

/** Composes the material's shaders from the registry, and again after a live edit. */
function compose(material: ShaderMaterial, registry: MicroShaderRegistry, options: PassMaterialOptions): void {
  const raw = (material as RawShaderMaterial).isRawShaderMaterial === true;
  const { vertexShader, fragmentShader } = registry.compose(options.vertex, options.fragment);
  material.vertexShader = (raw ? PRECISION : '') + vertexShader;
  material.fragmentShader = (raw ? PRECISION + GLSL1_NAMES : FULL_PRECISION) + fragmentShader;
  material.needsUpdate = true;
}

function follow(material: ShaderMaterial, registry: MicroShaderRegistry, options: PassMaterialOptions): () => void {
  material.customProgramCacheKey = () => `${threeChunks.revision}`;
  compose(material, registry, options);
  const names = [...options.vertex, ...options.fragment];
  let revision = registry.revision(names);
  return registry.onChange(() => {
    const now = registry.revision(names);
    if (now === revision) return;
    revision = now;
    compose(material, registry, options);
  });
}

function parameters(options: PassMaterialOptions): ShaderMaterialParameters {
  const { vertex: _v, fragment: _f, ...rest } = options;
  return { transparent: false, depthTest: false, depthWrite: false, fog: false, toneMapped: false, ...rest };
}

/**
 * Makes `version` of a class also count changes of three's chunks, which the shaders include. Defined on the prototype, since an
 * accessor on each material would give it a slow hidden class, slowing three's reads of all materials.
 */
function countChunks(prototype: ShaderMaterial): void {
  Object.defineProperty(prototype, 'version', {
    get(this: Versioned) {
      return this.ownVersion + threeChunks.revision;
    },
    set(this: Versioned, version: number) {
      this.ownVersion = version - threeChunks.revision;
    },
  });
}

/** Material of a pass into one of Farol's targets, composed of microshaders; no state of three's changes its program. */
export class PassMaterial extends RawShaderMaterial {
  private readonly unfollow: () => void;

  static {
    countChunks(PassMaterial.prototype);
  }

  constructor(registry: MicroShaderRegistry, options: PassMaterialOptions) {
    super({ glslVersion: GLSL3, ...parameters(options) });
    this.allowOverride = false;
    this.unfollow = follow(this, registry, options);
  }

  override dispose(): void {
    this.unfollow();
    super.dispose();
  }
}

/** Material of a pass into the host's target, with three's tone mapping, colour space and fog for that target. */
export class OutputMaterial extends ShaderMaterial {
  /** Whether draws with the material are in the reactive mask. Default false. */
  isReactive = false;
  private readonly unfollow: () => void;

  static {
    countChunks(OutputMaterial.prototype);
  }

  constructor(registry: MicroShaderRegistry, options: PassMaterialOptions) {
    super(parameters(options));
    this.allowOverride = false;
    this.unfollow = follow(this, registry, options);
  }

  override dispose(): void {
    this.unfollow();
    super.dispose();
  }
}
