import type { ParticlePresetName } from '@farol/renderer/particles';
import { LateCode } from '../base/LateCode';
import type { RequiredEffect } from '../core/RequiredEffect';
import type { ParticleValues } from './particleSettings';

const late = new LateCode(
  () => import('./particleRuntime'),
  'The code of particles could not be fetched: see that the network is there, and add one again.',
);

/** The code of particles; null until `loadParticleCode` is done. */
export const particleCode = () => late.code;

/**
 * Fetches the code of particles, also the renderer's, which most scenes do not need.
 * @throws Error (as a rejection) when it cannot be fetched; try again
 */
export const loadParticleCode = () => late.load();

/**
 * Values of a ParticleEmitter's fields for a common effect: `object.addComponent(ParticleEmitter, await
 * particlePreset('fire'))`.
 * @throws Error (as a rejection) when the code of particles cannot be fetched; try again
 */
export async function particlePreset(name: ParticlePresetName): Promise<Partial<ParticleValues>> {
  const { particlePresets, particleValues } = await loadParticleCode();
  return particleValues(particlePresets[name]);
}

/** The effect that draws particles. */
export const particlesEffect: RequiredEffect = {
  get effectClass() {
    return late.code?.Particles ?? null;
  },
  load: loadParticleCode,
};
