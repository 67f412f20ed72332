import { Mesh, MeshBasicMaterial } from 'three';
import { expect, it } from 'vitest';
import { RenderQueue } from './RenderQueue';

/** Depths of the opaque items of a queue, in the order in which they are drawn. */
function sortedDepths(ranked: boolean, ordered = false, custom = false): number[] {
  const queue = new RenderQueue();
  queue.clear();
  const [first, second] = [new MeshBasicMaterial(), new MeshBasicMaterial()];
  if (ranked) queue.ranks = new Map([first, second].map((material, i) => [material, 1 - i]));
  const push = (z: number, material: MeshBasicMaterial, renderOrder = 0) => {
    const mesh = Object.assign(new Mesh(undefined, material), { renderOrder });
    queue.push(mesh, mesh.geometry, material, 0, z, null, null);
  };
  for (const z of [40, 5, -1, 0.6]) push(z, first);
  for (const z of [41, 4, 0.3]) push(z, second);
  push(0.1, second, 1);
  queue.finish();
  queue.ordered = ordered;
  queue.sort(custom ? (a, b) => b.z - a.z : null, null, false);
  return queue.opaque.map((item) => item.z);
}

const asThree = [-1, 0.6, 5, 40, 0.3, 4, 41, 0.1];

it('sorts opaque items as three does: by render order, material, then front to back', () => {
  expect(sortedDepths(false)).toEqual(asThree);
});

it('draws materials by their ranks, where neither the host nor an item has an order of its own', () => {
  expect(sortedDepths(true)).toEqual([0.3, 4, 41, -1, 0.6, 5, 40, 0.1]);
  expect(sortedDepths(true, true), 'an item must be drawn in order').toEqual(asThree);
  expect(sortedDepths(true, false, true), "the host's order").toEqual([41, 40, 5, 4, 0.6, 0.3, 0.1, -1]);
});
