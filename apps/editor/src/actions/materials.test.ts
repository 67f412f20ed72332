import { GameObject, ObjectRenderer } from '@farol/engine';
import { expect, it } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { EditorDocument } from '../model/EditorDocument';
import { newMaterial } from './materials';

it('gives a new material to the selected objects, as one step', async () => {
  const document = new EditorDocument();
  const [chosen, other] = ['Chosen', 'Other'].map((name) => {
    const object = new GameObject(name);
    object.addComponent(ObjectRenderer, { mesh: 'box' });
    document.scene.add(object);
    return object;
  });
  document.selection.set([chosen.id]);
  const editor = { document, commands: document.commands, layout: { open() {} } } as unknown as EditorApi;
  await newMaterial.run(editor);
  const materialOf = (object: GameObject): string | null => object.getComponent(ObjectRenderer)!.material;
  expect(materialOf(chosen)).toBe(document.assetSelection.primary);
  expect(materialOf(other)).toBeNull();
  document.commands.undo();
  expect(materialOf(chosen)).toBeNull();
  expect(document.commands.history).toHaveLength(0);
});
