import { expect, test } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { Dialogs } from '../model/Dialogs';
import { EditorDocument } from '../model/EditorDocument';
import { Notices } from '../model/Notices';
import { importFiles, importOnly } from './importFiles';

/** A triangle. */
const ply = `ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
3 0 1 2
`;

const filesOf = (name: string): Map<string, File> => new Map([[name, new File([ply], name)]]);

test('files whose bytes are there already are used as they are, and importing them alone says so', async () => {
  const document = new EditorDocument();
  const { commands } = document;
  const notices = new Notices();
  const editor = { document, commands, notices, dialogs: new Dialogs(), mayUnpack: () => true } as unknown as EditorApi;
  await importOnly(editor, filesOf('triangle.ply'));
  expect(document.assets.has('triangle.ply', 'mesh')).toBe(true);
  expect(notices.current).toEqual([]);
  expect(commands.history).toEqual(['Imported triangle.ply']);
  expect(await importFiles(editor, filesOf('other.ply'))).toEqual({ names: ['triangle.ply'], known: ['triangle.ply'] });
  expect(notices.current).toEqual([]);
  await importOnly(editor, filesOf('other.ply'));
  expect(notices.current.map(({ text }) => text)).toEqual(['There already, with the same content: triangle.ply.']);
  expect(commands.history.length).toBe(1);
});
