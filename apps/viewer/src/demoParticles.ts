import { GameObject, ParticleEmitter, type Scene } from '@farol/engine';
import { Box3, Vector3 } from 'three';

const NAME = 'Particles';
/** Lifetime of a particle (s). */
const LIFE = 6;

/**
 * Fills a scene with particles that are lights, or removes them; the same in every run.
 * @param count - number of living particles; 0 for none
 */
export function setDemoParticles(scene: Scene, count: number): void {
  const present = scene.roots.find(({ name }) => name === NAME);
  const emitter = present?.getComponent(ParticleEmitter);
  if ((emitter ? emitter.rate * LIFE : 0) === count) return;
  present?.dispose();
  if (count === 0) return;
  scene.three.updateMatrixWorld(true);
  const bounds = new Box3().setFromObject(scene.three);
  if (!bounds.isEmpty()) scene.add(demoParticles(bounds, count));
}

function demoParticles(bounds: Box3, count: number): GameObject {
  const object = new GameObject(NAME);
  const size = bounds.getSize(new Vector3());
  const { x, y, z } = bounds.getCenter(new Vector3());
  const height = Math.min(size.y * 0.6, 8);
  object.transform.position = [x, Math.min(y, bounds.min.y + size.y * 0.1 + height / 2), z];
  object.addComponent(ParticleEmitter, {
    ...{ rate: count / LIFE, capacity: count + 16, prewarm: LIFE, lifeFrom: LIFE, lifeTo: LIFE },
    ...{ shape: 'box', boxSize: [size.x * 0.6, height, size.z * 0.6], speedFrom: -0.1, speedTo: 0.1, drag: 0.8 },
    ...{ noiseStrength: 0.7, noiseFrequency: 0.5, noiseScroll: 0.25 },
    ...{ sizeFrom: 0.02, sizeTo: 0.04, brightness: 4, softness: 0 },
    colourOverLife: [
      [0, [1, 0.55, 0.15], 0],
      [0.15, [1, 0.5, 0.12], 1],
      [0.5, [0.35, 0.9, 0.3], null],
      [0.85, [0.2, 0.45, 1], 1],
      [1, [0.2, 0.3, 1], 0],
    ],
    ...{ shine: true, lightEvery: 1, lightIntensity: 0.08, lightRange: 0.5 },
  });
  return object;
}
