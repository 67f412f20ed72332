import { LinearFilter, Mesh, MeshStandardMaterial, PlaneGeometry, PointLight, Texture } from 'three';
import { expect, it } from 'vitest';
import type { BakedMesh } from './Bake';
import { restoreBake } from './restoreBake';

const bakedMesh = (lightmap: number): BakedMesh => {
  const mesh = new Mesh(new PlaneGeometry(), new MeshStandardMaterial());
  const sourceVertex = Uint32Array.from([0, 1, 2, 3]);
  return { mesh, lightmap, uv1: new Float32Array(8), index: Uint32Array.from([0, 2, 1, 2, 3, 1]), sourceVertex };
};

it('lightmaps of halves and of textures are read by the set of UVs of the bake, and go with it', () => {
  const halves = { width: 2, height: 1, data: Uint16Array.from([1, 2, 3, 4, 5, 6, 7, 8]) };
  const compressed = new Texture();
  const meshes = [bakedMesh(0), bakedMesh(1)];
  const light = new PointLight();
  const bake = restoreBake({ lightmaps: [halves, compressed], meshes, channel: 2, probes: null }, { lights: [light] });
  expect([bake.lightmaps, bake.channel, bake.isApplied]).toEqual([[halves], 2, false]);
  bake.apply();
  expect(bake.isApplied).toBe(true);
  const maps = meshes.map(({ mesh }) => (mesh.material as MeshStandardMaterial).lightMap!);
  expect(maps.map(({ channel }) => channel)).toEqual([2, 2]);
  expect(maps[1]).toBe(compressed);
  expect(maps[0]).toMatchObject({ magFilter: LinearFilter, minFilter: LinearFilter, version: 1 });
  expect(maps[0].image).toMatchObject({ width: 2, height: 1, data: halves.data });
  for (const { mesh } of meshes) expect(mesh.geometry.hasAttribute('uv2')).toBe(true);
  expect(light.layers.mask).toBe(0);

  let freed = 0;
  for (const map of maps) map.addEventListener('dispose', () => freed++);
  bake.remove();
  expect([bake.isApplied, light.layers.mask, freed]).toEqual([false, 1, 0]);
  expect(meshes.map(({ mesh }) => (mesh.material as MeshStandardMaterial).lightMap)).toEqual([null, null]);
  bake.apply();
  bake.dispose();
  expect([bake.isApplied, light.layers.mask, freed]).toEqual([false, 1, 2]);
});
