import { currentOf } from '@farol/editing';
import { growthOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import { builtinComponents } from '../components/index';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { inNode } from './testing/inNode';
import { SceneScripts } from './SceneScripts';

const spin = (rate: number): string => `import { component, number } from '@farol/engine/fields';
export default class Spin extends component({ rate: number(${rate}, { help: 'For a test.' }) }) {}
`;

test('an edit of a script makes its components anew by work that grows with their number', async () => {
  const growth = await growthOf(100, async (count) => {
    const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
    const scene = new Scene({ registry });
    scene.assets.addFieldAsset('script', 'Spin', { source: spin(1) });
    const scripts = new SceneScripts(scene, registry, inNode);
    await scripts.settled();
    const components = Array.from({ length: count }, () => {
      const object = new GameObject('Top');
      scene.add(object);
      return object.addComponent('Spin');
    });
    scene.update(1);
    return async () => {
      scene.assets.fieldAsset('Spin')!.set('source', spin(2));
      await scripts.settled();
      scene.update(1);
      if (!components.every((each) => currentOf(each).get('rate') === 2))
        throw new Error('They are of the former class.');
    };
  });
  expect(growth).toBeLessThan(4.5);
});
