import type { ParticlePresetName } from '@farol/renderer/particles';
import { LateCode } from '../base/LateCode';
import type { RequiredEffect } from '../core/RequiredEffect';
import type { ParticleValues } from './particleSettings';

/** The code of particles, also the renderer's, which most scenes do not need. */
export const particleCode = new LateCode(
  () => import('./particleRuntime'),
  'The code of particles could not be fetched: see that the network is there, and add one again.',
);

/**
 * Values of a ParticleEmitter's fields for a common effect: `object.addComponent(ParticleEmitter, await
 * particlePreset('fire'))`.
 * @throws Error (as a rejection) when the code of particles cannot be fetched; call again
 */
export async function particlePreset(name: ParticlePresetName): Promise<Partial<ParticleValues>> {
  const { particlePresets, particleValues } = await particleCode.load();
  return particleValues(particlePresets[name]);
}

/** The effect that draws particles. */
export const particlesEffect: RequiredEffect = {
  get effectClass() {
    return particleCode.code?.Particles ?? null;
  },
  load: () => particleCode.load(),
};
