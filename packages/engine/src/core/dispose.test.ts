import { Object3D } from 'three';
import { expect, test } from 'vitest';
import { GameObject } from './GameObject';
import { Scene } from './Scene';

const COUNT = 1000;

/** Counts the list entries read by searches. */
function watchSearches(list: unknown[]): () => number {
  let looked = 0;
  list.indexOf = (entry) => {
    const index = Array.prototype.indexOf.call(list, entry);
    looked += index < 0 ? list.length : index + 1;
    return index;
  };
  list.lastIndexOf = (entry) => {
    const index = Array.prototype.lastIndexOf.call(list, entry);
    looked += list.length - index;
    return index;
  };
  return () => looked;
}

test.each([
  ['at the top', false],
  ['below one object', true],
])('%s, objects are disposed of without a search through all others for each', (_, isBelow) => {
  const scene = new Scene();
  const above = new GameObject('Above');
  scene.add(above);
  const parent = isBelow ? above : scene;
  for (let i = 0; i < COUNT; i++) parent.add(new GameObject('Each'));
  // three objects added after the GameObjects' own, like meshes of instances
  parent.threeParent.add(new Object3D());
  const last = parent.childList.at(-1)!;
  const told: string[] = [];
  last.object3D.addEventListener('removed', () => told.push('removed'));
  const searches = [watchSearches(parent.childList), watchSearches(parent.threeParent.children)];
  scene.dispose();
  for (const looked of searches) expect(looked()).toBeLessThan(COUNT * 4);
  expect(told).toEqual(['removed']);
  expect(last.object3D.parent).toBeNull();
  expect(scene.roots).toHaveLength(0);
  expect(scene.three.children).toHaveLength(0);
});
