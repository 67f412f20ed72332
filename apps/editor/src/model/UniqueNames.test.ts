import { GameObject, Scene } from '@farol/engine';
import { expect, it } from 'vitest';
import { addObject, duplicateObjects } from './edits';
import { UniqueNames } from './UniqueNames';

function sceneOf(...names: string[]): Scene {
  const scene = new Scene();
  for (const name of names) scene.add(new GameObject(name));
  return scene;
}

it('numbers a name that is taken, by the first number that is free', () => {
  const names = new UniqueNames(sceneOf('Box', 'Box 2', 'Box 4', 'Level 007', '2'));
  expect(['Box', 'Box', 'Sphere', 'Sphere', 'Box 4'].map((name) => names.take(name))).toEqual([
    'Box 3',
    'Box 5',
    'Sphere',
    'Sphere 2',
    'Box 6',
  ]);
  expect([names.take('2'), names.take('Level 007')]).toEqual(['2 2', 'Level 8']);
});

it('numbers thousands at once', () => {
  const names = new UniqueNames(sceneOf('Light'));
  const given = Array.from({ length: 20_000 }, () => names.take('Light'));
  expect(given.at(-1)).toBe('Light 20001');
  expect(new Set(given).size).toBe(20_000);
});

it('names what is added and duplicated, and calls the step by what was copied', () => {
  const scene = sceneOf('Box');
  const add = addObject(scene, new GameObject('Box'), scene, []);
  add.do();
  expect(add.label).toBe('Added Box 2');
  const duplicate = duplicateObjects(scene, scene.roots);
  duplicate.do();
  expect(duplicate.label).toBe('Duplicated 2 objects');
  expect(scene.roots.map(({ name }) => name)).toEqual(['Box', 'Box 3', 'Box 2', 'Box 4']);
});
