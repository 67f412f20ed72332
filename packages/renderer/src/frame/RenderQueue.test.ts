import { Mesh, MeshBasicMaterial } from 'three';
import { expect, it } from 'vitest';
import { RenderQueue } from './RenderQueue';

/** Depths of the opaque items of a queue, in the order in which a pass that draws each once does so; its order reverses three's. */
function sortedDepths(ranked: boolean, ordered = false, custom = false, reversed = false): number[] {
  const queue = new RenderQueue();
  if (ranked) queue.order = { pivot: 9, draw() {}, sort: ({ opaque }) => opaque.toReversed() };
  queue.clear();
  const [first, second] = [new MeshBasicMaterial(), new MeshBasicMaterial()];
  const push = (z: number, material: MeshBasicMaterial, renderOrder = 0) => {
    const mesh = Object.assign(new Mesh(undefined, material), { renderOrder });
    queue.push(mesh, mesh.geometry, material, 0, z, null, null);
  };
  for (const z of [40, 5, -1, 0.6]) push(z, first);
  for (const z of [41, 4, 0.3]) push(z, second);
  push(0.1, second, 1);
  queue.finish();
  queue.ordered = ordered;
  queue.sort(custom ? (a, b) => b.z - a.z : null, null, reversed);
  const depths = queue.beginOrder().map((item) => item.z);
  expect(queue.pivot).toBe(ranked && !ordered && !custom && !reversed ? 9 : 0);
  queue.pivot = 0;
  expect(queue.pivot).toBe(0);
  return depths;
}

const asThree = [-1, 0.6, 5, 40, 0.3, 4, 41, 0.1];

it('sorts opaque items as three does: by render order, material, then front to back', () => {
  expect(sortedDepths(false)).toEqual(asThree);
});

it('has an order of materials where neither the host nor an item has an order of its own', () => {
  expect(sortedDepths(true)).toEqual(asThree.toReversed());
  expect(sortedDepths(true, false, false, true), 'lists that three reverses').toEqual(asThree.toReversed());
  expect(sortedDepths(true, true), 'an item must be drawn in order').toEqual(asThree);
  expect(sortedDepths(true, false, true), "the host's order").toEqual([41, 40, 5, 4, 0.6, 0.3, 0.1, -1]);
});
