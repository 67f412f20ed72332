import { expect, test, vi } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { Dialogs } from '../model/Dialogs';
import { EditorDocument } from '../model/EditorDocument';
import { Notices } from '../model/Notices';
import { dropOn } from './dropOn';

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

async function drop(...paths: string[]): Promise<{ opened: unknown[]; imported: readonly string[]; said: string[] }> {
  const document = new EditorDocument();
  const notices = new Notices();
  const openFileBytes = vi.fn<EditorApi['openFileBytes']>(async () => true);
  const { commands, assets } = document;
  const editor = {
    ...{ document, commands, notices, openFileBytes, dialogs: new Dialogs(), mayUnpack: () => true },
  } as unknown as EditorApi;
  const files = new Map(paths.map((path) => [path, new File([ply], path.slice(path.lastIndexOf('/') + 1))]));
  await dropOn(editor, { asset: null, files }, { kind: 'elsewhere' });
  const opened = openFileBytes.mock.calls.map(([, { name }]) => name);
  return { opened, imported: assets.files.map(({ name }) => name), said: notices.current.map(({ text }) => text) };
}

test('a scene among files is opened; a .json beside models is none', async () => {
  expect(await drop('room/wall.ply', 'room/room.farol')).toMatchObject({ opened: ['room.farol'], imported: [] });
  expect(await drop('scene.json')).toMatchObject({ opened: ['scene.json'] });
  // libraries of scans put what they know of a model beside it
  expect(await drop('rock/asset.json', 'rock/rock.ply')).toMatchObject({ opened: [], imported: ['rock.ply'] });
  expect(await drop('rock/license.txt', 'rock/scene.json')).toMatchObject({ opened: ['scene.json'] });
});
