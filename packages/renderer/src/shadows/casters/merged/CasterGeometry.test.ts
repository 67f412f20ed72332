import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  SphereGeometry,
} from 'three';
import { describe, expect, it } from 'vitest';
import { CasterGeometry } from './CasterGeometry';
import { CLUSTER_TRIANGLES } from './ClusterOrder';

function made(geometry: ConstructorParameters<typeof CasterGeometry>[0]): CasterGeometry {
  const result = new CasterGeometry(geometry);
  while (!result.isDone) result.step(100);
  return result;
}

/** The triangles as texts, corners in their order from the least one on, so that they can be compared as sets. */
function triangles(positions: ArrayLike<number>, index: ArrayLike<number>): string[] {
  const corner = (i: number) => [0, 1, 2].map((axis) => positions[index[i] * 3 + axis].toFixed(4)).join();
  const result: string[] = [];
  for (let i = 0; i < index.length; i += 3) {
    const corners = [corner(i), corner(i + 1), corner(i + 2)];
    const least = corners.indexOf([...corners].sort()[0]);
    result.push([0, 1, 2].map((k) => corners[(least + k) % 3]).join(' '));
  }
  return result.sort();
}

describe('CasterGeometry', () => {
  const sphere = new SphereGeometry(2, 24, 16);

  it('has the triangles of an indexed geometry, turned as they were, and of one without index', () => {
    const expected = triangles(sphere.attributes.position.array, sphere.index!.array);
    const indexed = made(sphere);
    expect(triangles(indexed.positions, indexed.index)).toEqual(expected);
    const loose = made(sphere.toNonIndexed());
    expect(triangles(loose.positions, loose.index)).toEqual(expected);
  });

  it('takes the vertices alone that triangles have', () => {
    const part = new BoxGeometry();
    part.setIndex([0, 1, 2]);
    expect(made(part).positions.length).toBe(9);
  });

  it('has the tight box of each cluster', () => {
    const { positions, index, boxes } = made(sphere);
    const perCluster = CLUSTER_TRIANGLES * 3;
    expect(boxes.length).toBe(Math.ceil(index.length / perCluster) * 6);
    for (let cluster = 0; cluster * 6 < boxes.length; cluster++) {
      const own = index.subarray(cluster * perCluster, (cluster + 1) * perCluster);
      for (let axis = 0; axis < 3; axis++) {
        const values = [...own].map((vertex) => positions[vertex * 3 + axis]);
        const [centre, half] = [boxes[cluster * 6 + axis], boxes[cluster * 6 + 3 + axis]];
        expect(Math.min(...values)).toBeCloseTo(centre - half, 5);
        expect(Math.max(...values)).toBeCloseTo(centre + half, 5);
      }
    }
  });

  it('knows when positions or index have changed', () => {
    const changing = new BoxGeometry();
    const result = made(changing);
    expect(result.isCurrent).toBe(true);
    changing.attributes.position.needsUpdate = true;
    expect(result.isCurrent).toBe(false);
    const shared = new InterleavedBuffer(new Float32Array(18), 6);
    const interleaved = new BufferGeometry().setAttribute('position', new InterleavedBufferAttribute(shared, 3, 0));
    const part = made(interleaved);
    expect(part.isCurrent).toBe(true);
    shared.needsUpdate = true;
    expect(part.isCurrent).toBe(false);
    const other = new BoxGeometry();
    const replaced = made(other);
    other.setIndex(new BufferAttribute(new Uint16Array([0, 1, 2]), 1));
    expect(replaced.isCurrent).toBe(false);
  });

  it('is not sound where a position is not a number', () => {
    const broken = new BoxGeometry();
    broken.attributes.position.setX(3, NaN);
    expect(made(broken).isSound).toBe(false);
  });
});
