import { ParticleEmitter } from '@farol/renderer/particles';
import { Box3, type PointLight, Vector3 } from 'three';
import type { LightPath } from './LightPaths';

/** Lifetime of a particle (s); it is then replaced by another one, so that their number is constant. */
const LIFE = 4;
/** Lowest and highest speed upwards (m/s). */
const SPEED = [0.1, 0.6] as const;
/** Smallest and largest diameter (m). */
const SIZE = [0.02, 0.05] as const;

/** The lights of a case as particles that the GPU moves. */
export interface MovingParticles {
  readonly emitter: ParticleEmitter;
  /** Advances the particles to a time (s); does nothing for an earlier time than that of the last call. */
  setTime(seconds: number): void;
}

/**
 * Creates a particle for each light, in the box in which the lights move; their number is constant. Their motion does
 * not depend on the time steps, so that all competitors draw equal pictures at a time.
 *
 * @param lights - lights whose mean colour and intensity, and whose range, the particles have
 */
export function movingParticles(lights: readonly PointLight[], paths: readonly LightPath[]): MovingParticles {
  const count = lights.length;
  const box = new Box3();
  for (const { place, extent } of paths) {
    const [centre, half] = [new Vector3(...place), new Vector3(...extent)];
    box.expandByPoint(centre.clone().sub(half)).expandByPoint(centre.add(half));
  }
  if (box.isEmpty()) box.set(new Vector3(-1, 0, -1), new Vector3(1, 1, 1));
  const mean = new Vector3();
  for (const { color, intensity } of lights) {
    mean.add(new Vector3(color.r, color.g, color.b).multiplyScalar(intensity / count));
  }
  const brightest = Math.max(mean.x, mean.y, mean.z, 1e-6);
  const colour = [mean.x / brightest, mean.y / brightest, mean.z / brightest] as const;
  const emitter = new ParticleEmitter({
    ...{ capacity: Math.max(1, count), rate: count / LIFE, life: [LIFE, LIFE], prewarm: LIFE },
    shape: { kind: 'box', size: box.getSize(new Vector3()).toArray() },
    ...{ speed: SPEED, size: SIZE, blending: 'additive' },
    colorOverLife: [
      [0, colour, 0],
      [0.1, colour, 1],
      [0.8, colour, 1],
      [1, colour, 0],
    ],
    lightEvery: 1,
    lightIntensity: brightest,
    lightRange: lights[0]?.distance ?? 1,
  });
  box.getCenter(emitter.position);
  let last = 0;
  return {
    emitter,
    setTime(seconds) {
      emitter.step(Math.max(0, seconds - last));
      last = seconds;
    },
  };
}
