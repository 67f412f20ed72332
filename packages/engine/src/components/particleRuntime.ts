/** Late code of scenes with particles, fetched with the first emitter. */
export { ParticleEmitter, particlePresets, Particles } from '@farol/renderer/particles';
export { changedSetting, particleSettings, particleValues } from './particleSettings';
