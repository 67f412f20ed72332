import { BoxGeometry, BufferGeometry, Float32BufferAttribute, SphereGeometry, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import { computeCreaseNormals } from './computeCreaseNormals';

const plain = (geometry: BufferGeometry, indexed = true): BufferGeometry => {
  geometry.deleteAttribute('normal');
  return indexed ? geometry : geometry.toNonIndexed();
};

const normalAt = (geometry: BufferGeometry, i: number): Vector3 =>
  new Vector3().fromBufferAttribute(geometry.getAttribute('normal'), i);
const positionAt = (geometry: BufferGeometry, i: number): Vector3 =>
  new Vector3().fromBufferAttribute(geometry.getAttribute('position'), i);

/** A cube with 8 shared vertices, as in a file without normals. */
function sharedCube(): BufferGeometry {
  const corners = [-1, 1].flatMap((x) => [-1, 1].flatMap((y) => [-1, 1].map((z) => [x, y, z])));
  const faces = [
    0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3,
  ];
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute(corners.flat(), 3));
  geometry.setIndex(faces);
  return geometry;
}

describe('a cube', () => {
  test.each([
    ['of shared vertices', sharedCube()],
    ['without index', sharedCube().toNonIndexed()],
    ['of three', plain(new BoxGeometry())],
  ])('%s has 24 vertices, whose normals are its faces', (_, source) => {
    const cube = computeCreaseNormals(source);
    expect(cube.getAttribute('position').count).toBe(24);
    expect(cube.index!.count).toBe(36);
    const distinct = new Set<string>();
    for (let i = 0; i < 24; i++) {
      const normal = normalAt(cube, i);
      expect(Math.max(Math.abs(normal.x), Math.abs(normal.y), Math.abs(normal.z))).toBeCloseTo(1, 9);
      expect(normal.dot(positionAt(cube, i))).toBeGreaterThan(0);
      distinct.add([...normal.toArray(), ...positionAt(cube, i).toArray()].map(Math.round).join());
    }
    expect(distinct.size).toBe(24);
  });

  test('is all smooth at a crease angle of π: the corners point away from the middle', () => {
    const cube = computeCreaseNormals(sharedCube(), Math.PI);
    expect(cube.getAttribute('position').count).toBe(8);
    for (let i = 0; i < 8; i++) {
      expect(normalAt(cube, i).angleTo(positionAt(cube, i))).toBeLessThan(1e-6);
    }
  });
});

describe('a sphere', () => {
  test('is smooth, across the seam of its texture coordinates and at its poles too', () => {
    const sphere = computeCreaseNormals(plain(new SphereGeometry(2, 48, 24)));
    const { count } = sphere.getAttribute('position');
    for (let i = 0; i < count; i++) expect(normalAt(sphere, i).angleTo(positionAt(sphere, i))).toBeLessThan(0.01);
    expect(sphere.getAttribute('uv').count).toBe(count);
  });

  test('is flat at a crease angle of 0', () => {
    const sphere = computeCreaseNormals(plain(new SphereGeometry(1, 8, 6)), 0);
    const index = sphere.index!;
    for (let corner = 0; corner < index.count; corner += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => normalAt(sphere, index.getX(corner + k)));
      expect(a.angleTo(b) + b.angleTo(c)).toBeLessThan(0.01);
    }
  });
});

test('the cut of a face into triangles does not show: normals do not lean to the side with more of them', () => {
  const cube = computeCreaseNormals(sharedCube(), Math.PI);
  const normal = normalAt(cube, 0);
  expect(Math.abs(normal.x)).toBeCloseTo(Math.abs(normal.y), 6);
  expect(Math.abs(normal.y)).toBeCloseTo(Math.abs(normal.z), 6);
});

test('a triangle without area gets a normal of length 1 and spoils no other', () => {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 0, -1, 0.5, 0, 0], 3));
  geometry.setIndex([0, 1, 2, 0, 3, 1]);
  const result = computeCreaseNormals(geometry);
  for (let i = 0; i < result.getAttribute('normal').count; i++) {
    expect(normalAt(result, i).y).toBeCloseTo(1, 6);
  }
});

test('groups are kept and the source is left as it was', () => {
  const source = plain(new BoxGeometry());
  const result = computeCreaseNormals(source);
  expect(source.getAttribute('normal')).toBeUndefined();
  expect(result.groups).toEqual(source.groups);
});

test('few faces that meet are smooth at any angle', () => {
  expect(computeCreaseNormals(sharedCube(), Math.PI).getAttribute('position').count).toBe(8);
});
