import { GameObject, Light } from '@farol/engine';
import { expect, it } from 'vitest';
import type { EditorApi } from '../../api/EditorApi';
import { EditorDocument } from '../../model/EditorDocument';
import { fieldSearchOf } from '../inspector/fieldSearch';
import { componentItems, fieldItems } from './fieldItems';
import { matchItems } from './matchItems';

function makeEditor() {
  const document = new EditorDocument();
  const opened: string[] = [];
  const layout = { open: (panel: string) => opened.push(panel) };
  return { editor: { document, commands: document.commands, layout } as unknown as EditorApi, opened };
}

it('finds fields of the scene, and shows one in the inspector in place of the selection', () => {
  const { editor, opened } = makeEditor();
  const object = new GameObject('Lamp');
  editor.document.scene.add(object);
  editor.document.selection.set([object.id]);
  const [found] = matchItems(fieldItems(editor), 'tone mapping');
  expect(found).toMatchObject({ label: 'Tone mapping', group: 'Scene' });
  found.run();
  expect(editor.document.selection.ids).toEqual([]);
  expect(fieldSearchOf(editor).text).toBe('Tone mapping');
  expect(opened).toEqual(['inspector']);
  // the search is cleared with the selection when it is for a field of that; typed text is kept until another scene
  editor.document.selection.set([object.id]);
  expect(fieldSearchOf(editor).text).toBe('');
  fieldSearchOf(editor).find('position');
  editor.document.selection.clear();
  expect(fieldSearchOf(editor).text).toBe('position');
  editor.document.opened.emit();
  expect(fieldSearchOf(editor).text).toBe('');
});

it('finds the fields that the inspector shows of the selection, by their help too, and components to add', () => {
  const { editor } = makeEditor();
  expect(componentItems(editor)).toEqual([]);
  const object = new GameObject('Lamp');
  object.addComponent(Light, { type: 'point' });
  editor.document.scene.add(object);
  editor.document.selection.set([object.id]);
  const labels = (query: string): string[] =>
    matchItems(fieldItems(editor), query).map(({ label, group }) => `${group}: ${label}`);
  expect(labels('range light')[0]).toBe('Light: Range');
  expect(labels('cutoff')).toEqual([]);
  expect(labels('where the light ends')).toContain('Light: Range');
  const [camera] = matchItems(componentItems(editor), 'camera');
  camera.run();
  expect(object.getComponent('Camera')).not.toBeNull();
  editor.document.commands.undo();
  expect(object.getComponent('Camera')).toBeNull();
});
