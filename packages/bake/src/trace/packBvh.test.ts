import {
  Raycaster,
  type Mesh,
  TorusKnotGeometry,
  Vector3,
  Mesh as ThreeMesh,
  MeshBasicMaterial,
  DoubleSide,
} from 'three';
import { expect, it } from 'vitest';
import { packBvh, type PackedBvh } from './packBvh';

/** Distance to the first triangle along a ray, traversing the hierarchy like the shader. */
function firstHit({ nodes, order, depth }: PackedBvh, positions: Float32Array, from: Vector3, along: Vector3): number {
  let nearest = Infinity;
  const stack = [0];
  const [a, b, c, at] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
  for (let node = stack.pop(); node !== undefined; node = stack.pop()) {
    for (const side of [0, 8]) {
      const o = 16 * node + side;
      let [near, far] = [0, nearest];
      for (let k = 0; k < 3; k++) {
        const [t0, t1] = [0, 4].map((e) => (nodes[o + e + k] - from.getComponent(k)) / along.getComponent(k));
        near = Math.max(near, Math.min(t0, t1));
        far = Math.min(far, Math.max(t0, t1));
      }
      if (near > far) continue;
      if (nodes[o + 7] === 0) stack.push(nodes[o + 3]);
      for (let i = 0; i < nodes[o + 7]; i++) {
        const t = 9 * order[nodes[o + 3] + i];
        [a, b, c].forEach((corner, k) => corner.fromArray(positions, t + 3 * k));
        const hit = rayTriangle(from, along, a, b, c, at);
        if (hit !== null) nearest = Math.min(nearest, hit);
      }
    }
    expect(stack.length).toBeLessThanOrEqual(depth + 1);
  }
  return nearest;
}

function rayTriangle(from: Vector3, along: Vector3, a: Vector3, b: Vector3, c: Vector3, at: Vector3): number | null {
  const [u, v] = [b.clone().sub(a), c.clone().sub(a)];
  const n = u.clone().cross(v);
  const t = a.clone().sub(from).dot(n) / along.dot(n);
  at.copy(from).addScaledVector(along, t).sub(a);
  const x = at.clone().cross(v).dot(n) / n.lengthSq();
  const y = u.clone().cross(at).dot(n) / n.lengthSq();
  return t > 0 && x >= 0 && y >= 0 && x + y <= 1 ? t : null;
}

it('finds the same first hits as three, over a closed shape and over a single triangle', () => {
  const geometry = new TorusKnotGeometry(1, 0.3, 80, 12).toNonIndexed();
  const positions = geometry.getAttribute('position').array as Float32Array;
  const packed = packBvh(positions.slice());
  expect(Array.from(packed.order).toSorted((a, b) => a - b)).toEqual(Array.from(packed.order, (_, i) => i));
  const mesh: Mesh = new ThreeMesh(geometry, new MeshBasicMaterial({ side: DoubleSide }));
  let hits = 0;
  for (let i = 0; i < 60; i++) {
    const from = new Vector3(Math.sin(i * 7.1) * 3, Math.cos(i * 3.3) * 3, Math.sin(i * 1.7 + 1) * 3);
    const along = new Vector3(Math.sin(i), Math.cos(2 * i), Math.sin(3 * i)).multiplyScalar(0.8).sub(from).normalize();
    const [expected] = new Raycaster(from, along).intersectObject(mesh);
    const found = firstHit(packed, positions, from, along);
    if (expected) {
      hits++;
      expect(found).toBeCloseTo(expected.distance, 4);
    } else expect(found).toBe(Infinity);
  }
  expect(hits).toBeGreaterThan(20);

  const one = packBvh(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]));
  const corners = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]);
  const down = new Vector3(1e-9, 1e-9, -1).normalize();
  expect(firstHit(one, corners, new Vector3(0.2, 0.2, 5), down)).toBeCloseTo(5);
  expect(firstHit(one, corners, new Vector3(0.8, 0.8, 5), down)).toBe(Infinity);
});
