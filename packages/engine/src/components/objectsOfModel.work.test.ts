import { growthOf } from '@farol/tools/workOf';
import { BufferAttribute, BufferGeometry, Group, Mesh, MeshStandardMaterial } from 'three';
import { expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { Model } from '../assets/Model';
import { objectsOfModel } from './objectsOfModel';

test('very many materials of one name, all different, are told apart by work that grows with them alone', async () => {
  const geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(9), 3));
  let names: string[] = [];
  const growth = await growthOf(200, (count) => {
    const root = new Group();
    for (let i = 0; i < count; i++) root.add(new Mesh(geometry, new MeshStandardMaterial({ roughness: i / count })));
    return () => {
      const { materials } = objectsOfModel(new Model(root, []), new AssetLibrary(), 'many.glb');
      names = materials.map(({ name }) => name);
    };
  });
  expect(growth).toBeLessThan(4.5);
  expect(new Set(names).size).toBe(800);
});
