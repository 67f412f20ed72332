import { BufferGeometry, Float32BufferAttribute, GLBufferAttribute, Mesh, SphereGeometry } from 'three';
import { expect, test, vi } from 'vitest';
import { aliasTable, surfaceTable, TEXELS_PER_TRIANGLE } from './surfaceTable';

test('by the alias method each is as likely as its weight', () => {
  const weights = Float64Array.of(3, 0, 1, 6, 0.5, 2.5);
  const { share, alias } = aliasTable(weights);
  const likely = new Float64Array(weights.length);
  share.forEach((each, i) => {
    likely[i] += each / weights.length;
    likely[alias[i]] += (1 - each) / weights.length;
  });
  weights.forEach((weight, i) => expect(likely[i]).toBeCloseTo(weight / 13, 10));
});

test('triangles of a mesh count by their areas in the world, with their corners and normals', () => {
  const geometry = new BufferGeometry();
  // two right triangles with legs 1 and 1, 1 and 2
  geometry.setAttribute(
    'position',
    new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 2, 1, 0, 0], 3),
  );
  const mesh = new Mesh(geometry);
  mesh.scale.set(1, 4, 1); // this makes the first four times as large
  mesh.updateMatrixWorld();
  const table = surfaceTable(mesh)!;
  expect(table.triangles).toBe(2);
  const texel = (triangle: number, i: number) => {
    const at = 4 * (triangle * TEXELS_PER_TRIANGLE + i);
    return [...table.data.subarray(at, at + 4)];
  };
  expect(texel(0, 1).slice(0, 3)).toEqual([1, 0, 0]);
  expect(texel(1, 1).slice(0, 3)).toEqual([0, 0, 2]);
  // areas 2 and 1: the second is drawn two times of three, else the first
  expect([texel(0, 0)[3], texel(1, 0)[3], texel(1, 1)[3]]).toEqual([1, expect.closeTo(2 / 3, 6), 0]);
  expect(texel(0, 3).slice(0, 3)).toEqual([0, 0, 1]);
  expect(texel(1, 5).slice(0, 3)).toEqual([0, 2, 0]);
});

test('of an indexed geometry the normals of the vertices are taken; without area there is no table', () => {
  const sphere = new Mesh(new SphereGeometry(2, 6, 4));
  const { data, triangles } = surfaceTable(sphere)!;
  for (let t = 0; t < triangles; t++) {
    const at = 4 * t * TEXELS_PER_TRIANGLE;
    for (let i = 0; i < 3; i++) expect(data[at + 12 + i]).toBeCloseTo(data[at + i] / 2, 5);
  }
  const flat = new BufferGeometry();
  flat.setAttribute('position', new Float32BufferAttribute([0, 0, 0, 1, 0, 0, 2, 0, 0], 3));
  expect(surfaceTable(new Mesh(flat))).toBeNull();
  expect(surfaceTable(new Mesh(new BufferGeometry()))).toBeNull();
});

test('no table is made of vertices that the CPU cannot read, which is said', () => {
  const warn = vi.spyOn(console, 'warn').mockReturnValue();
  const freed = new SphereGeometry(2, 6, 4);
  (freed.attributes.position as { array: unknown }).array = null;
  const onGPU = new BufferGeometry().setAttribute('position', new GLBufferAttribute({}, 5126, 3, 4, 3) as never);
  expect([freed, onGPU].map((geometry) => surfaceTable(new Mesh(geometry)))).toEqual([null, null]);
  expect(warn.mock.calls.flat().map((text) => (text as string).replace(/".*"/, ''))).toEqual(
    Array.from(
      { length: 2 },
      () => 'Farol: no particles begin on Mesh , since its arrays were freed after upload; keep them.',
    ),
  );
  warn.mockRestore();
});
