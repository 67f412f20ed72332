import { BufferAttribute, SphereGeometry, TorusKnotGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { CLUSTER_VERTICES, triangleClusters } from './triangleClusters';

describe('triangleClusters', () => {
  const knot = new TorusKnotGeometry(1, 0.3, 100, 16);
  test.each([
    ['indexed', knot],
    ['not indexed', knot.toNonIndexed()],
  ])('boxes hold every vertex of their triangles, and touch some: %s', (_, geometry) => {
    const boxes = triangleClusters(geometry)!;
    const { position } = geometry.attributes;
    const vertices = geometry.index?.count ?? position.count;
    expect(boxes.length).toBe(6 * Math.ceil(vertices / CLUSTER_VERTICES));
    const point = new Vector3();
    for (let cluster = 0; cluster * 6 < boxes.length; cluster++) {
      const box = boxes.subarray(cluster * 6, cluster * 6 + 6);
      const reach = [0, 0, 0];
      const end = Math.min(vertices, (cluster + 1) * CLUSTER_VERTICES);
      for (let i = cluster * CLUSTER_VERTICES; i < end; i++) {
        point.fromBufferAttribute(position, geometry.index?.getX(i) ?? i);
        point.toArray().forEach((value, axis) => {
          reach[axis] = Math.max(reach[axis], Math.abs(value - box[axis]));
        });
      }
      reach.forEach((value, axis) => expect(value).toBeCloseTo(box[3 + axis], 5));
    }
    expect(triangleClusters(geometry)).toBe(boxes);
  });

  test('none for few triangles, broken positions, and geometries that change', () => {
    expect(triangleClusters(new SphereGeometry(1, 8, 8))).toBeNull();
    const broken = knot.clone();
    broken.attributes.position.setX(70, Infinity);
    expect(triangleClusters(broken)).toBeNull();
    const changing = knot.clone();
    expect(triangleClusters(changing)).not.toBeNull();
    (changing.attributes.position as BufferAttribute).needsUpdate = true;
    expect(triangleClusters(changing)).toBeNull();
    expect(triangleClusters(changing)).toBeNull();
  });
});
