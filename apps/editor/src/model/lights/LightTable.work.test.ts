import { createRandom, GameObject, Light } from '@farol/engine';
import { growthOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import { EditorDocument } from '../EditorDocument';
import { LightTable } from './LightTable';

test('filtering and sorting lights grow with their number alone, but for the logarithm of a sort', async () => {
  const random = createRandom(3);
  const growth = await growthOf(1000, (count) => {
    const document = new EditorDocument();
    for (let i = 0; i < count; i++) {
      const object = new GameObject(`Lamp ${i + 1}`);
      document.scene.add(object);
      object.addComponent(Light, { intensity: random() });
    }
    const table = new LightTable(document);
    table.connect();
    return () => {
      table.setFilter({ text: '1' });
      table.sortBy('intensity');
      expect(table.rows.length).toBeGreaterThan(0);
    };
  });
  expect(growth).toBeLessThan(5);
});
