import { GameObject, ObjectRenderer, Scene } from '@farol/engine';
import { BoxGeometry } from 'three';
import { afterAll, beforeAll, expect, it, vi } from 'vitest';
import { exportInTest, PageFileReader } from './testing/exportInTest';

beforeAll(() => vi.stubGlobal('FileReader', PageFileReader));
afterAll(() => vi.unstubAllGlobals());

it('meshes whose vertices are on the GPU alone are named as left out of a file', async () => {
  const scene = new Scene();
  scene.assets.register('case', new BoxGeometry());
  const object = new GameObject('Case');
  object.addComponent(ObjectRenderer, { mesh: 'case' });
  scene.add(object);
  // as a script may, after three has uploaded the array
  for (const attribute of Object.values(object.getComponent(ObjectRenderer)!.geometry!.attributes))
    (attribute as { array: unknown }).array = null;
  const { leftOut } = await exportInTest(scene);
  expect(leftOut).toContain('Meshes whose arrays were freed are left out (1)');
  scene.dispose();
});
