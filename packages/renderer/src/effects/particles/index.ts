export { ParticleEmitter } from './ParticleEmitter';
export { Particles } from './Particles';
export type { ParticleTextures } from './ParticleState';
export { particleDefaults } from './particleDefaults';
export { particlePresets, type ParticlePresetName } from './particlePresets';
export { curveAt, gradientAt } from './bakeCurves';
export type {
  CurveKey,
  EmitterShape,
  FlipBook,
  GradientKey,
  ParticleBurst,
  ParticleCollider,
  ParticleSettings,
} from './ParticleSettings';
