import { bench, describe } from 'vitest';
import { Light } from '../components/Light';
import { RandomMovement } from '../components/RandomMovement';
import { RigidBody } from '../components/RigidBody';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import { PhysicsSystem } from '../physics/PhysicsSystem';
import { box, ground, makeScene, prepare } from '../components/testing/physicsScene';

/**
 * Time of a physics step with 1,000 dynamic boxes and 500 moving lights: of Rapier, and of the engine besides. `npx
 * vitest bench --run --config packages/vitest.config.ts physics`
 */
const median = (times: readonly number[]): number => times.toSorted((a, b) => a - b)[Math.floor(times.length / 2)];

/** @param apart - how far the boxes are apart (m): below 1.2 they fall into heaps */
async function boxes(columns: number, apart: number): Promise<Scene> {
  const scene = makeScene();
  const random = createRandom(5);
  scene.add(ground());
  for (let i = 0; i < 1000; i++) {
    const [x, z, y] = [i % columns, Math.floor(i / columns) % columns, Math.floor(i / columns / columns)];
    const jitter = (): number => random() * 0.1;
    scene.add(
      box(`Box ${i}`, [(x - columns / 2) * apart + jitter(), 0.6 + y * 1.2, (z - columns / 2) * apart + jitter()]),
    );
  }
  for (let i = 0; i < 500; i++) {
    const light = new GameObject(`Light ${i}`);
    light.transform.position = [random() * 40 - 20, 1 + random() * 4, random() * 40 - 20];
    light.addComponent(Light, { intensity: 2, range: 4 });
    light.addComponent(RandomMovement, { seed: i });
    scene.add(light);
  }
  await prepare(scene);
  return scene;
}

const scenes = { 'side by side': await boxes(32, 1.2), 'in a heap 10 high': await boxes(10, 1.15) };

/** CPU time of all threads of the process (ms), unaffected by other processes. */
const processorTime = (): number => {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
};

for (const [name, scene] of Object.entries(scenes)) {
  const system = scene.system(PhysicsSystem);
  const bodies = scene.componentsOf(RigidBody);
  const steps: { rapier: number; engine: number; awake: number }[] = [];
  const clock = performance.now.bind(performance);
  // PhysicsSystem takes its times from performance.now
  performance.now = processorTime;
  for (let i = 0; i < 600; i++) {
    // thrown upwards once a second, so that bodies do not fall asleep
    if (i % 60 === 0) for (const body of bodies) body.applyImpulse([0, i === 0 ? 0 : 4, 0]);
    scene.update(1 / 60);
    const awake = bodies.filter((body) => !body.isSleeping).length;
    steps.push({ rapier: system.times.rapier, engine: system.times.all - system.times.rapier, awake });
  }
  performance.now = clock;
  const of = (value: 'rapier' | 'engine' | 'awake'): string => median(steps.map((step) => step[value])).toFixed(2);
  console.log(
    `1,000 boxes ${name}, median of 600 steps: Rapier ${of('rapier')} ms, engine ${of('engine')} ms, awake ${of('awake')}`,
  );
}

describe('a frame of the scene as it rests', () => {
  const [scene] = Object.values(scenes);
  bench('update', () => scene.update(1 / 60));
});
