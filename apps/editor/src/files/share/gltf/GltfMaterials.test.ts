import { AssetLibrary, GameObject, ObjectRenderer, Scene } from '@farol/engine';
import { type Mesh, MeshStandardMaterial } from 'three';
import { beforeAll, expect, test } from 'vitest';
import { loadSurfaces } from '../../../model/testing/randomSurfaceCommand';
import { GltfMaterials } from './GltfMaterials';
import { LeftOut } from './LeftOut';

beforeAll(loadSurfaces);

test('a surface is told by its name and those of the objects; what is written is the material without it', async () => {
  const assets = new AssetLibrary();
  const scene = new Scene({ assets });
  const source = 'void surface(inout SurfaceData s) {}';
  assets.addFieldAsset('surface', 'Rust', { source });
  assets.addFieldAsset('surface', 'Snow', { source });
  assets.addMaterial('Steel', { surface: 'Rust', colour: [0.5, 0.25, 0.125], roughness: 0.75 });
  const leftOut = new LeftOut();
  const materials = new GltfMaterials(null as never, leftOut);
  const written = [];
  for (const name of ['a', 'b', 'c', 'd', 'e']) {
    const object = new GameObject(name);
    scene.add(object);
    const renderer = object.addComponent(ObjectRenderer, { material: 'Steel', surface: name === 'e' ? 'Snow' : null });
    const { material } = renderer.three as Mesh;
    const use = { user: `'${name}'`, object: name, hasUV: false, hasTangents: false };
    written.push(await materials.convert(material as MeshStandardMaterial, use));
  }
  expect(leftOut.lines).toEqual([
    'The surface Rust is left out: a, b, c, … (5)',
    'The surface Snow is left out: e (1)',
  ]);
  expect(new Set(written).size).toBe(1);
  expect(written[0]).toMatchObject({ roughness: 0.75, userData: {} });
  expect((written[0] as MeshStandardMaterial).color.toArray()).toEqual([0.5, 0.25, 0.125]);
  scene.dispose();
});
