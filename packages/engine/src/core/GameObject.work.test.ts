import { growthOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import '../components/index';
import { GameObject } from './GameObject';

test('an object of very many components is copied by work that grows with their square at most', async () => {
  let copy: GameObject;
  const growth = await growthOf(250, (count) => {
    const object = new GameObject('Many');
    for (let i = 0; i < count; i++) object.addComponent('EventTrigger', {}, { id: `c${i}` });
    return () => (copy = object.clone());
  });
  expect(growth).toBeLessThan(16);
  expect(new Set(copy!.components.map(({ id }) => id)).size).toBe(1001);
});
