import {
  AdditiveBlending,
  CustomBlending,
  DoubleSide,
  Matrix3,
  MaxEquation,
  NormalBlending,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SrcAlphaFactor,
  type Texture,
  UniformsLib,
  UniformsUtils,
  Vector3,
  Vector4,
} from 'three';
import { OutputMaterial } from '../../gpu/PassMaterial';
import { unprojectUniforms } from '../../gpu/unprojectUniforms';
import type { Frame } from '../../frame/Frame';
import { addMicroShaders } from '../../microshaders/addMicroShaders';
import particleCurves from './particleCurves.glsl?raw';
import particleFragment from './particleFragment.glsl?raw';
import type { ParticleSettings } from './ParticleSettings';
import particleSurroundings from './particleSurroundings.glsl?raw';
import particleRandom from './particleRandom.glsl?raw';
import particleVertex from './particleVertex.glsl?raw';

const noTexture = () => ({ value: null as Texture | null });

/** Makes the uniforms of one emitter's material. */
export function particleUniforms() {
  return {
    ...(UniformsUtils.clone(UniformsLib.fog) as typeof UniformsLib.fog),
    ...unprojectUniforms(),
    farol_particlePositions: noTexture(),
    farol_particleVelocities: noTexture(),
    farol_particleCurves: noTexture(),
    farol_particleSeed: { value: 0 },
    farol_particleSlots: { value: new Int32Array(2) },
    farol_oldestNumber: { value: 0 },
    farol_sizeAndRotation: { value: new Vector4() },
    farol_spinAndStretch: { value: new Vector4() },
    farol_orientation: { value: 0 },
    farol_emitterTurn: { value: new Matrix3() },
    farol_flipBook: { value: new Vector3(1, 1, 1) },
    farol_particleOrder: noTexture(),
    farol_particleRed: noTexture(),
    farol_particleGreen: noTexture(),
    farol_particleBlue: noTexture(),
    farol_surroundings: noTexture(),
    farol_particleMap: noTexture(),
    farol_particleDepth: noTexture(),
    farol_particleDistances: noTexture(),
    farol_particleStored: { value: 0 },
    farol_softness: { value: new Vector4() },
  };
}

/** Settings that select an emitter's program and blending. */
export type ParticleLook = Pick<ParticleSettings, 'render' | 'blending' | 'lit'> & {
  readonly map: boolean;
  readonly soft: boolean;
  readonly sorted: boolean;
  /** Whether the material writes the reactive mask. Default false. */
  readonly reactive?: boolean;
};

/** Blending equal to NormalBlending, but ignored by WeightedBlendedOIT. */
const OVER = {
  blending: CustomBlending,
  blendSrc: SrcAlphaFactor,
  blendDst: OneMinusSrcAlphaFactor,
  blendSrcAlpha: OneFactor,
  blendDstAlpha: OneMinusSrcAlphaFactor,
} as const;

/** Blending of the reactive mask: keeps the greater value. */
const GREATEST = {
  blending: CustomBlending,
  blendEquation: MaxEquation,
  blendSrc: OneFactor,
  blendDst: OneFactor,
} as const;

const BLENDINGS = {
  blended: OVER,
  additive: { blending: AdditiveBlending },
  weighted: { blending: NormalBlending },
} as const;

/** Material of an emitter's particles, with three's tone mapping, colour space, fog and clipping. */
export function particleMaterial(
  frame: Frame,
  look: ParticleLook,
  uniforms: ReturnType<typeof particleUniforms>,
): OutputMaterial {
  addMicroShaders(frame.microshaders, 'Particles', {
    particleRandom,
    particleCurves,
    particleSurroundings,
    particleVertex,
    particleFragment,
  });
  const defines: Record<string, string> = {};
  if (look.render !== 'billboard') defines[look.render === 'mesh' ? 'FAROL_MESH' : 'FAROL_STRETCHED'] = '';
  if (look.lit) defines.FAROL_LIT = '';
  if (look.map) defines.FAROL_MAP = '';
  if (look.soft) defines.FAROL_SOFT = '';
  if (look.reactive) defines.FAROL_REACTIVE = '';
  if (look.sorted) defines.FAROL_SORTED = '';
  const material = new OutputMaterial(frame.microshaders, {
    name: 'Farol particles',
    vertex: ['particleVertex'],
    fragment: ['particleFragment'],
    uniforms: {
      ...uniforms,
      farol_hiding: { value: look.blending === 'additive' ? 0 : 1 },
      farol_offset: frame.uniforms.farol_offset,
      farol_media: frame.uniforms.farol_media,
      farol_mediaSpace: frame.uniforms.farol_mediaSpace,
    },
    defines,
    transparent: true,
    depthTest: true,
    // mesh particles occlude one another, and write depth
    depthWrite: look.reactive !== true && look.render === 'mesh' && look.blending !== 'additive',
    fog: look.reactive !== true,
    toneMapped: look.reactive !== true,
    side: DoubleSide,
  });
  material.setValues(look.reactive ? GREATEST : BLENDINGS[look.blending]);
  material.isReactive = true;
  material.forceSinglePass = true;
  material.clipping = true;
  return material;
}
