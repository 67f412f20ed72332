import { AudioSource, GameObject } from '@farol/engine';
import { expect, test } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { EditorDocument } from '../model/EditorDocument';
import { placeAsset } from './placeAsset';

test('a sound that is dropped on an object is heard from it', async () => {
  const document = new EditorDocument();
  const editor = { document, commands: document.commands } as unknown as EditorApi;
  const box = new GameObject('Box');
  document.scene.add(box);
  for (const name of ['creak.flac', 'steps.m4a', 'bell.ogg']) document.assets.registerFile(name, new Blob([name]));
  const drop = (name: string, target: GameObject | null): Promise<void> =>
    placeAsset(editor, { kind: document.assets.typeOf(name)!, name }, { target, parent: target ?? undefined });
  const heard = (): unknown[] => box.getComponents(AudioSource).map((each) => each.getAuthored('sound'));

  await drop('creak.flac', box);
  expect([heard(), document.scene.roots.length, box.children.length]).toEqual([['creak.flac'], 1, 0]);
  expect(document.selection.ids).toEqual([box.id]);
  // an AudioSource without a sound gets it, in one step
  box.addComponent(AudioSource);
  await drop('steps.m4a', box);
  expect(heard()).toEqual(['creak.flac', 'steps.m4a']);
  await drop('bell.ogg', box);
  expect(heard()).toEqual(['creak.flac', 'steps.m4a', 'bell.ogg']);
  document.commands.undo();
  document.commands.undo();
  expect(heard()).toEqual(['creak.flac', null]);
});
