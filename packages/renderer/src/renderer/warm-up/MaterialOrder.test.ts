import { Mesh, MeshBasicMaterial } from 'three';
import { expect, it } from 'vitest';
import type { RenderItem } from '../../frame/RenderItem';
import { MaterialOrder, MOST_MATERIALS } from './MaterialOrder';

let seed = 1;
/** Pseudo-random whole number below `below`. */
const random = (below: number): number => (seed = (seed * 16807) % 2147483647) % below;

/** Wastes of random pairs, some of which waste nothing. */
function randomWastes(count: number): Float64Array {
  const wastes = new Float64Array(MOST_MATERIALS ** 2);
  for (let one = 0; one < count; one++)
    for (let other = 0; other < count; other++) wastes[one * MOST_MATERIALS + other] = Math.max(0, random(30) - 10);
  return wastes;
}

/** Waste of an order; below its first material, items of one material are drawn from far to near. */
function wasteOf(order: readonly number[], wastes: Float64Array): number {
  let waste = 0;
  for (const one of order) if (one < order[0]) waste += wastes[one * MOST_MATERIALS + one];
  order.forEach((one, i) => order.slice(i + 1).forEach((other) => (waste += wastes[one * MOST_MATERIALS + other])));
  return waste;
}

/** All orders in which each next one lies beside those before it. */
function growing(low: number, high: number): number[][] {
  if (low === high) return [[low]];
  return [
    ...growing(low + 1, high).map((order) => [...order, low]),
    ...growing(low, high - 1).map((order) => [...order, high]),
  ];
}

const indices = (count: number): number[] => Array.from({ length: count }, (_, i) => i);

it('wastes least of all orders that grow by neighbours', () => {
  const order = new MaterialOrder(() => {});
  let gains = 0;
  for (let trial = 0; trial < 200; trial++) {
    const count = 1 + (trial % 8);
    const wastes = randomWastes(count);
    const ids = indices(count).map((i) => 10 * i);
    const saved = order.find(ids, wastes);
    const found = indices(count).toSorted((a, b) => order.rankOf(item(ids[a], 0)) - order.rankOf(item(ids[b], 0)));
    const all = count === 1 ? [[0]] : growing(0, count - 1);
    expect(all.map(String)).toContain(String(found));
    const least = Math.min(...all.map((one) => wasteOf(one, wastes)));
    expect(wasteOf(found, wastes)).toBe(least);
    expect(saved).toBe(wasteOf(indices(count), wastes) - least);
    expect(order.pivot).toBe(ids[found[0]]);
    if (saved > 0) gains++;
  }
  expect(gains).toBeGreaterThan(100);
});

const materials = new Map<number, RenderItem['material']>();

const item = (id: number, z: number, more: Partial<RenderItem> = {}): RenderItem => {
  const material = materials.get(id) ?? ({ id, transparent: false } as RenderItem['material']);
  materials.set(id, material);
  const object = new Mesh(undefined, material);
  return { object, material, groupOrder: 0, renderOrder: 0, z, shading: 'lit', ...more } as RenderItem;
};

/** Items in an order; null for three's. @param far - an item whose depth may equal the cleared depth */
const sort = (order: MaterialOrder, items: readonly RenderItem[], far: RenderItem | null = null) =>
  order.sort({ opaque: items, cleared: 9, reaches: (object) => object === far?.object });

/** Draws items with whole depths at the pixels of a row. @returns index of the visible item at each pixel */
function draw(items: readonly RenderItem[], pivot: number, depths: ReadonlyMap<RenderItem, readonly number[]>) {
  const seen = Array.from({ length: 12 }, () => ({ depth: Infinity, item: null as RenderItem | null }));
  for (const one of items) {
    depths.get(one)!.forEach((depth, x) => {
      const isStrict = one.material.id < pivot;
      if (isStrict ? depth < seen[x].depth : depth <= seen[x].depth) seen[x] = { depth, item: one };
    });
  }
  return seen.map((pixel) => pixel.item);
}

it('shows, of items at one depth, the one that three shows, also of materials that it does not know', () => {
  const order = new MaterialOrder(() => {});
  let moved = 0;
  for (let trial = 0; trial < 500; trial++) {
    const count = 1 + random(10);
    const all = indices(count + random(6)).flatMap((i) => {
      const id = 3 * i + random(3);
      return indices(1 + random(3)).map((z) => item(id, z));
    });
    const ids = [...new Set(all.map(({ material }) => material.id))];
    const known = ids.filter((_, i) => i === 0 || random(3) > 0);
    order.find(known, randomWastes(known.length));
    const depths = new Map(all.map((one) => [one, indices(12).map(() => (random(4) === 0 ? NaN : random(3)))]));
    const sorted = sort(order, all) ?? all;
    expect(new Set(sorted)).toEqual(new Set(all));
    if (sorted.some((one, i) => one !== all[i])) moved++;
    expect(draw(sorted, order.pivot, depths)).toEqual(draw(all, 0, depths));
  }
  expect(moved).toBeGreaterThan(200);
});

it("leaves three's order to items of several render orders, and of blended or node materials", () => {
  const order = new MaterialOrder(() => {});
  const wastes = new Float64Array(MOST_MATERIALS ** 2);
  wastes[1] = 1; // the first material is hidden by the second
  order.find([4, 8], wastes);
  const [low, high] = [item(4, 1), item(8, 2)];
  const near = item(4, 0.5);
  expect(sort(order, [near, low, high])).toEqual([high, low, near]);
  expect(sort(order, [near, low, high], low)).toBeNull();
  expect(sort(order, [near, low, high], high)).not.toBeNull();
  expect(sort(order, [])).toBeNull();
  expect(sort(order, [low, item(8, 0, { renderOrder: 1 })])).toBeNull();
  expect(sort(order, [low, item(8, 0, { groupOrder: 1 })])).toBeNull();
  expect(sort(order, [low, item(8, 0, { shading: 'nodes' })])).toBeNull();
  expect(sort(order, [low, item(8, 0, { material: new MeshBasicMaterial({ transparent: true }) })])).toBeNull();
});
