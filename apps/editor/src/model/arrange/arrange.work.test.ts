import { GameObject, Light, Scene } from '@farol/engine';
import { growthOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import { EditorDocument } from '../EditorDocument';
import { arrangement } from '../testing/randomArrangement';
import { arrangedPlaces } from './arrangedPlaces';
import { arrangeObjects } from './arrangeObjects';

test('lamps are arranged by work that grows with their number', async () => {
  const growth = await growthOf(5, (along) => {
    const document = new EditorDocument();
    const scene = new Scene({ assets: document.assets });
    const lamp = new GameObject('Lamp');
    lamp.addComponent(Light, { intensity: 10, range: 5 });
    scene.add(lamp);
    document.open(scene);
    const counts: [number, number, number] = [20, 1, along];
    const grid = arrangement({ kind: 'grid', counts, colours: 'random', intensityVariation: 0.3, grouped: true });
    return () => {
      document.commands.run(arrangeObjects(scene, [lamp], arrangedPlaces(grid, [[1, 2, 3]]), grid));
      expect(scene.componentsOf(Light).length).toBe(20 * along);
    };
  });
  expect(growth).toBeLessThan(4.5);
});
