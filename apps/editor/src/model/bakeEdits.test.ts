import { GameObject, Light, ObjectRenderer, RandomMovement, Scene } from '@farol/engine';
import { expect, it } from 'vitest';
import { countForBake } from './bakeEdits';

it('counts what could be baked as it is added, while nothing is', () => {
  const scene = new Scene();
  const add = (name: string): GameObject => {
    const object = new GameObject(name);
    scene.add(object);
    return object;
  };
  expect(countForBake(scene)).toEqual([0, 0, 0, 0, 0]);
  const floor = add('Floor');
  floor.addComponent(ObjectRenderer, { mesh: 'plane' });
  expect(countForBake(scene)).toEqual([0, 0, 0, 1, 0]);
  const ball = add('Ball');
  ball.addComponent(ObjectRenderer, { mesh: 'sphere' });
  ball.addComponent(RandomMovement);
  add('Lamp').addComponent(Light);
  expect(countForBake(scene)).toEqual([0, 0, 0, 1, 1]);
  floor.isStatic = true;
  expect(countForBake(scene)).toEqual([1, 0, 0, 0, 1]);
});
