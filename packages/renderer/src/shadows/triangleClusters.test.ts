import { BufferAttribute, BufferGeometry, MathUtils, SphereGeometry, TorusKnotGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { CLUSTER_VERTICES, triangleClusters } from './triangleClusters';

/** Triangles that share no vertex, one further than the other: the first and the last of a cluster are at its ends. */
function soup(triangles: number): BufferGeometry {
  MathUtils.seededRandom(7);
  const values = Float32Array.from(
    { length: triangles * 9 },
    (_, i) => (Math.floor(i / 9) + MathUtils.seededRandom()) / 100 - 5,
  );
  return new BufferGeometry().setAttribute('position', new BufferAttribute(values, 3));
}

describe('triangleClusters', () => {
  const knot = new TorusKnotGeometry(1, 0.3, 101, 16);
  test.each([
    ['indexed', knot],
    ['not indexed', knot.toNonIndexed()],
    ['separate triangles', soup(1000)],
    ['separate triangles, one over a whole number of clusters', soup(1025)],
  ])('boxes hold every vertex of their triangles, and touch some on each side: %s', (_, geometry) => {
    const boxes = triangleClusters(geometry)!;
    const { position } = geometry.attributes;
    const vertices = geometry.index?.count ?? position.count;
    expect(vertices % CLUSTER_VERTICES, 'the last cluster is cut short').not.toBe(0);
    expect(boxes.length).toBe(6 * Math.ceil(vertices / CLUSTER_VERTICES));
    const point = new Vector3();
    for (let cluster = 0; cluster * 6 < boxes.length; cluster++) {
      const box = boxes.subarray(cluster * 6, cluster * 6 + 6);
      const low = [Infinity, Infinity, Infinity];
      const high = [-Infinity, -Infinity, -Infinity];
      const end = Math.min(vertices, (cluster + 1) * CLUSTER_VERTICES);
      for (let i = cluster * CLUSTER_VERTICES; i < end; i++) {
        point.fromBufferAttribute(position, geometry.index?.getX(i) ?? i);
        point.toArray().forEach((value, axis) => {
          low[axis] = Math.min(low[axis], value);
          high[axis] = Math.max(high[axis], value);
        });
      }
      for (let axis = 0; axis < 3; axis++) {
        expect(box[axis] - box[3 + axis]).toBeCloseTo(low[axis], 5);
        expect(box[axis] + box[3 + axis]).toBeCloseTo(high[axis], 5);
      }
    }
    expect(triangleClusters(geometry)).toBe(boxes);
  });

  test('none for few triangles and broken positions', () => {
    expect(triangleClusters(new SphereGeometry(1, 8, 8))).toBeNull();
    const broken = knot.clone();
    broken.attributes.position.setX(70, Infinity);
    expect(triangleClusters(broken)).toBeNull();
  });

  test.each<[string, (geometry: BufferGeometry) => void]>([
    ['positions', ({ attributes }) => ((attributes.position as BufferAttribute).needsUpdate = true)],
    ['index', ({ index }) => (index!.needsUpdate = true)],
    ['attribute', (geometry) => geometry.setAttribute('position', geometry.attributes.position.clone())],
    ['index, by another one', (geometry) => geometry.setIndex(geometry.index!.clone())],
  ])('none for geometries that change: %s', (_, change) => {
    const geometry = knot.clone();
    expect(triangleClusters(geometry)).not.toBeNull();
    change(geometry);
    expect(triangleClusters(geometry)).toBeNull();
    expect(triangleClusters(geometry)).toBeNull();
  });
});
