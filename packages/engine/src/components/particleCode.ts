import type { ParticlePresetName } from '@farol/renderer/particles';
import type { RequiredEffect } from '../core/RequiredEffect';
import type { ParticleValues } from './particleSettings';

type ParticleCode = typeof import('./particleRuntime');

let code: ParticleCode | null = null;
let loading: Promise<void> | null = null;

/** The code of particles; null until `loadParticleCode` is done. */
export const particleCode = (): ParticleCode | null => code;

/** Fetches the code of particles, the renderer's too, which most scenes do without. @throws Error when it cannot be fetched; try again */
export async function loadParticleCode(): Promise<void> {
  loading ??= import('./particleRuntime').then(
    (module) => void (code = module),
    (cause: unknown) => {
      loading = null;
      throw new Error('The code of particles could not be fetched: see that the network is there, and add one again.', {
        cause,
      });
    },
  );
  return loading;
}

/**
 * Values of a ParticleEmitter's fields for a common effect: `object.addComponent(ParticleEmitter, await particlePreset('fire'))`.
 * @throws Error (as a rejection) when the code of particles cannot be fetched; try again
 */
export async function particlePreset(name: ParticlePresetName): Promise<Partial<ParticleValues>> {
  await loadParticleCode();
  const { particlePresets, particleValues } = code!;
  return particleValues(particlePresets[name]);
}

/** The effect that draws particles. */
export const particlesEffect: RequiredEffect = {
  get effectClass() {
    return code?.Particles ?? null;
  },
  load: loadParticleCode,
};
