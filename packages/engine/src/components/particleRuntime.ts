/** What a scene with particles needs besides its components: fetched when there is one. */
export { ParticleEmitter, particlePresets, Particles } from '@farol/renderer/particles';
export { changedSetting, particleSettings, particleValues } from './particleSettings';
