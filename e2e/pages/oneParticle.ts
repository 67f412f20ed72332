import { ParticleEmitter, type ParticleSettings } from '@farol/renderer/particles';

/** An emitter of one white particle, born at the start, that keeps its place, size and colour; `settings` replace these. */
export function oneParticle(settings: Partial<ParticleSettings> = {}): ParticleEmitter {
  return new ParticleEmitter({
    capacity: 1,
    rate: 0,
    bursts: [{ time: 0, count: 1 }],
    life: [9, 9],
    speed: [0, 0],
    size: [1, 1],
    shape: { kind: 'point' },
    initialRotation: [0, 0],
    colorOverLife: [[0, [1, 1, 1], 1]],
    blending: 'blended',
    softness: 0,
    ...settings,
  });
}
