import {
  BoxGeometry,
  Color,
  type Material,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PlaneGeometry,
  PointLight,
  Scene,
  Texture,
} from 'three';
import { describe, expect, it } from 'vitest';
import type { BakedMesh } from '../Bake';
import { AppliedBake } from './AppliedBake';

/** A baked mesh with a duplicate of its first vertex. */
function bakedMesh(mesh: Mesh): BakedMesh {
  const count = mesh.geometry.attributes.position.count;
  const sourceVertex = Uint32Array.from({ length: count + 1 }, (_, i) => i % count);
  const index = Uint32Array.from(mesh.geometry.index!.array);
  index[0] = count;
  return { mesh, lightmap: 0, uv1: new Float32Array(2 * (count + 1)).fill(0.5), index, sourceVertex };
}

describe('AppliedBake', () => {
  const texture = new Texture();

  it('dresses meshes and hides lights, and gives all back', () => {
    const shared = new MeshStandardMaterial({ color: 0x336699 });
    const unlit = new MeshBasicMaterial();
    const one = new Mesh(new PlaneGeometry(), shared);
    const two = new Mesh<BoxGeometry, Material[]>(new BoxGeometry(), [shared, unlit]);
    const light = new PointLight();
    const child = new Mesh();
    light.add(child);
    const before = [one.geometry, one.material, two.geometry, two.material];
    const names = Object.keys(one.geometry.attributes);
    const bake = new AppliedBake([bakedMesh(one), bakedMesh(two)], [light], [texture], 1, null);
    bake.apply();
    bake.apply();
    expect(bake.isApplied).toBe(true);
    const dressed = one.material as MeshStandardMaterial;
    expect([dressed.lightMap, dressed.lightMapIntensity]).toEqual([texture, 1]);
    expect([dressed.id, dressed.uuid]).not.toEqual([shared.id, shared.uuid]);
    expect(two.material).toEqual([dressed, unlit]);
    expect(two.material[0]).toBe(dressed);
    expect(one.geometry.attributes.uv1.count).toBe(5);
    expect(one.geometry.attributes.position.getX(4)).toBe(one.geometry.attributes.position.getX(0));
    expect(two.geometry.groups).toEqual(new BoxGeometry().groups);
    expect(light.layers.mask).toBe(0);
    expect(child.layers.mask).toBe(1);
    bake.remove();
    bake.remove();
    expect([one.geometry, one.material, two.geometry, two.material]).toEqual(before);
    expect(one.geometry).toBe(before[0]);
    expect(light.layers.mask).toBe(1);
    expect([shared.lightMap, Object.keys(one.geometry.attributes)]).toEqual([null, names]);
  });

  it('follows changes of the source, and keeps what somebody else sets meanwhile', () => {
    const source = new MeshStandardMaterial();
    const mesh: Mesh = new Mesh(new PlaneGeometry(), source);
    const bake = new AppliedBake([bakedMesh(mesh)], [], [texture], 1, null);
    bake.apply();
    const dressed = mesh.material as MeshStandardMaterial;
    source.color = new Color(0xff0000);
    source.roughness = 0.25;
    const { version } = dressed;
    source.needsUpdate = true;
    expect([dressed.color.getHex(), dressed.roughness]).toEqual([0xff0000, 0.25]);
    expect(dressed.version).toBe(version + 1);
    let told = 0;
    dressed.addEventListener('dispose', () => told++);
    source.dispose();
    expect(told).toBe(0);
    const other = new MeshStandardMaterial();
    mesh.material = other;
    bake.dispose();
    expect(mesh.material).toBe(other);
    expect(told).toBe(1);
  });

  it('shows of a baked environment what metals mirror', () => {
    const scene = new Scene();
    scene.environment = new Texture();
    scene.environmentIntensity = 0.5;
    const source = new MeshStandardMaterial({ metalness: 0.8 });
    const mesh = new Mesh(new PlaneGeometry(), source);
    new AppliedBake([bakedMesh(mesh)], [], [texture], 1, scene).apply();
    expect(mesh.material.envMap).toBe(scene.environment);
    expect(mesh.material.envMapIntensity).toBeCloseTo(0.4);
    source.metalness = 0;
    expect(mesh.material.envMapIntensity).toBe(0);
  });
});
