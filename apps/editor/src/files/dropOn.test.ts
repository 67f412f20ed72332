import { zipSync } from 'three/addons/libs/fflate.module.js';
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

async function drop(
  ...paths: (string | File)[]
): Promise<{ opened: unknown[]; imported: readonly string[]; said: string[] }> {
  const document = new EditorDocument();
  const notices = new Notices();
  const openFileBytes = vi.fn<EditorApi['openFileBytes']>(async () => true);
  const { commands, assets } = document;
  const editor = {
    ...{ document, commands, notices, openFileBytes, dialogs: new Dialogs(), mayUnpack: () => true },
  } as unknown as EditorApi;
  const files = new Map(
    paths.map((path) =>
      path instanceof File ? [path.name, path] : [path, new File([ply], path.slice(path.lastIndexOf('/') + 1))],
    ),
  );
  await dropOn(editor, { asset: null, files }, { kind: 'elsewhere' });
  const opened = openFileBytes.mock.calls.map(([, { name }]) => name);
  return { opened, imported: assets.files.map(({ name }) => name), said: notices.current.map(({ text }) => text) };
}

test('a scene among files is opened; a .json beside models is none', async () => {
  expect(await drop('room/wall.ply', 'room/room.farol')).toMatchObject({ opened: ['room.farol'], imported: [] });
  expect(await drop('scene.json')).toMatchObject({ opened: ['scene.json'] });
  // libraries of scanned models add metadata as JSON
  expect(await drop('rock/asset.json', 'rock/rock.ply')).toMatchObject({ opened: [], imported: ['rock.ply'] });
  expect(await drop('rock/license.txt', 'rock/scene.json')).toMatchObject({ opened: ['scene.json'] });
});

test('what is not taken beside a scene is named', async () => {
  expect((await drop('a.farol')).said).toEqual([]);
  const { opened, imported, said } = await drop('a.farol', 'b.farol', 'a.ply');
  expect([opened, imported]).toEqual([['a.farol'], []]);
  expect(said).toEqual(['a.farol was opened by itself, without b.farol, a.ply: drop these again.']);
});

const zipOf = (name: string, entries: Record<string, string>): File => {
  const bytes = Object.entries(entries).map(([path, content]) => [path, new TextEncoder().encode(content)] as const);
  return new File([new Uint8Array(zipSync(Object.fromEntries(bytes)))], name);
};

test('a scene file that was renamed to .zip is opened; one within a ZIP says what to do', async () => {
  const renamed = zipOf('room.ZIP', { 'scene.json': '{}', 'assets/wall.ply': ply });
  expect(await drop(renamed)).toMatchObject({ opened: ['room.farol'], imported: [] });
  // models are packed together with their metadata
  expect(await drop(zipOf('rock.zip', { 'rock/scene.json': '{}', 'rock/rock.ply': ply }))).toMatchObject({
    opened: [],
    imported: ['rock.ply'],
  });
  expect((await drop(zipOf('room.zip', { 'room.farol': '{}' }))).said).toEqual([
    'room/room.farol is a scene within a ZIP: unpack the ZIP, and open it by itself.',
  ]);
});
