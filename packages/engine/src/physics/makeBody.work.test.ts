import { growthOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import { box, makeScene, prepare, run } from '../components/testing/physicsScene';

test('bodies are made by work that grows with their number, not with its square', async () => {
  const growth = await growthOf(100, async (count) => {
    const scene = makeScene();
    for (let i = 0; i < count; i++) scene.add(box(`Cube ${i}`, [(i % 50) * 3, 0, Math.floor(i / 50) * 3]));
    await prepare(scene);
    return () => run(scene, 1);
  });
  expect(growth).toBeLessThan(4.5);
});
