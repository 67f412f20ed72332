import { BoxGeometry, type BufferGeometry, PlaneGeometry, TorusKnotGeometry } from 'three';
import { describe, expect, it } from 'vitest';
import createXAtlas from 'xatlas-wasm';
import { cutCharts } from './cutCharts';
import { packMeshes } from './packMeshes';
import type { SurfaceToUnwrap, Unwrapped, UnwrappedMesh, UnwrapRequest } from './UnwrapRequest';
import { unwrapMeshes } from './unwrapMeshes';

const xatlas = await createXAtlas();

/** Unwraps without workers. */
const unwrapHere = (request: UnwrapRequest, onProgress: (share: number) => void = () => {}): Promise<Unwrapped> =>
  unwrapMeshes(
    request,
    {
      cut: async (surface) => cutCharts(xatlas, surface),
      pack: async (surfaces, meshes, options, told) =>
        packMeshes(
          meshes.map((surface) => surfaces[surface]),
          options,
          told,
        ),
    },
    onProgress,
  );

const surface = (geometry: BufferGeometry): SurfaceToUnwrap => ({
  positions: geometry.getAttribute('position').array as Float32Array,
  normals: geometry.getAttribute('normal').array as Float32Array,
  index: Uint32Array.from(geometry.index!.array),
});

/** Lightmap texels whose centre a mesh covers, and whether two triangles without a common edge cover the same one. */
function cover(meshes: readonly UnwrappedMesh[], size: number): { covered: number; overlaps: number } {
  const owner = new Int32Array(size * size).fill(-1);
  let [covered, overlaps] = [0, 0];
  meshes.forEach(({ uv1, index }, m) => {
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => [uv1[2 * index[i + k]] * size, uv1[2 * index[i + k] + 1] * size]);
      const side = (p: number[], q: number[], x: number, y: number) =>
        (q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0]);
      const area = side(a, b, c[0], c[1]);
      if (Math.abs(area) < 1e-9) continue;
      const [xs, ys] = [0, 1].map((k) => [a, b, c].map((p) => p[k]));
      for (let y = Math.floor(Math.min(...ys)); y <= Math.max(...ys); y++)
        for (let x = Math.floor(Math.min(...xs)); x <= Math.max(...xs); x++) {
          const inside = [side(a, b, x + 0.5, y + 0.5), side(b, c, x + 0.5, y + 0.5), side(c, a, x + 0.5, y + 0.5)];
          // strictly inside: a centre on a common edge belongs to both
          if (!inside.every((s) => s * Math.sign(area) > 1e-3)) continue;
          const at = y * size + x;
          if (owner[at] >= 0) overlaps++;
          else covered++;
          owner[at] = m;
        }
    }
  });
  return { covered, overlaps };
}

describe('unwrapMeshes', () => {
  const box = surface(new BoxGeometry(2, 1, 1));
  const knot = surface(new TorusKnotGeometry(1, 0.3, 60, 12));

  it('lays every triangle out in 0 to 1, without overlaps, keeping their order', async () => {
    const shares: number[] = [];
    const request = { surfaces: [box, knot], meshes: [0, 1, 0], size: 128, padding: 2, texelsPerMetre: null };
    const { meshes, texelsPerMetre } = await unwrapHere(request, (share) => shares.push(share));
    expect(meshes.map(({ lightmap }) => lightmap)).toEqual([0, 0, 0]);
    expect(texelsPerMetre[0]).toBeGreaterThan(7);
    meshes.forEach(({ uv1, index, sourceVertex }, i) => {
      const from = [box, knot, box][i];
      expect(Array.from(index, (vertex) => sourceVertex[vertex])).toEqual(Array.from(from.index));
      for (const value of uv1) expect(value >= 0 && value <= 1).toBe(true);
    });
    const { covered, overlaps } = cover(meshes, 128);
    expect(overlaps).toBe(0);
    expect(covered).toBeGreaterThan(0.33 * 128 * 128);
    expect(shares.at(-1)).toBe(1);
    expect(shares).toEqual(shares.toSorted((a, b) => a - b));
  });

  it('takes as many lightmaps as a density asks for, each mesh in one', async () => {
    const plane = surface(new PlaneGeometry(1, 1));
    const request = { surfaces: [plane], meshes: Array(5).fill(0), size: 64, padding: 2, texelsPerMetre: 40 };
    const { meshes, texelsPerMetre } = await unwrapHere(request);
    expect(new Set(meshes.map(({ lightmap }) => lightmap)).size).toBe(texelsPerMetre.length);
    expect(texelsPerMetre.length).toBeGreaterThanOrEqual(3);
    for (const density of texelsPerMetre) expect(Math.abs(density - 40)).toBeLessThan(0.1);
    const [{ uv1 }] = meshes;
    const width = Math.max(...uv1.filter((_, i) => i % 2 === 0)) - Math.min(...uv1.filter((_, i) => i % 2 === 0));
    expect(Math.abs(width * 64 - 40)).toBeLessThan(0.1);
  });

  it('lays a mesh that is larger than a lightmap out more coarsely', async () => {
    const plane = surface(new PlaneGeometry(10, 10));
    const request = { surfaces: [plane], meshes: [0], size: 64, padding: 2, texelsPerMetre: 40 };
    const { texelsPerMetre } = await unwrapHere(request);
    expect(texelsPerMetre[0]).toBeLessThan(6.4);
    expect(texelsPerMetre[0]).toBeGreaterThan(3);
  });
});
