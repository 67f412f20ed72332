import { expect, test, vi } from 'vitest';
import type { EditorApi } from '../api/EditorApi';
import { Dialogs } from '../model/Dialogs';
import { EditorDocument } from '../model/EditorDocument';
import { Notices } from '../model/Notices';
import { importFiles, importOnly } from './importFiles';

/** A PLY file with one triangle. */
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
  expect(notices.current.map(({ text }) => text)).toEqual([
    'These exist already, with the same content: triangle.ply.',
  ]);
  expect(commands.history.length).toBe(1);
});

const editorOf = (): { editor: EditorApi; document: EditorDocument; notices: Notices } => {
  const document = new EditorDocument();
  const notices = new Notices();
  const { commands } = document;
  const editor = { document, commands, notices, dialogs: new Dialogs(), mayUnpack: () => true } as unknown as EditorApi;
  return { editor, document, notices };
};

test('the same bytes twice in one import come in once', async () => {
  const { editor, document } = editorOf();
  const files = new Map([...filesOf('first.ply'), ...filesOf('second.ply')]);
  expect(await importFiles(editor, files)).toEqual({ names: ['first.ply', 'first.ply'], known: ['first.ply'] });
  expect(document.assets.files.map(({ name }) => name)).toEqual(['first.ply']);
  document.commands.undo();
  expect(document.assets.files).toEqual([]);
});

test('a ZIP that cannot be read is told by name, and the files beside it come in', async () => {
  const { editor, document, notices } = editorOf();
  const files = new Map([...filesOf('triangle.ply'), ['cut.zip', new File(['PK'], 'cut.zip')] as const]);
  await importFiles(editor, files);
  expect(document.assets.has('triangle.ply', 'mesh')).toBe(true);
  expect(notices.current.map(({ kind, text }) => [kind, text])).toEqual([
    ['error', expect.stringMatching(/^cut\.zip: The file is cut short or damaged/)],
  ]);
  // the only file: the error is shown, since nothing was imported
  expect(await importFiles(editor, new Map([['a.zip', new File(['PK'], 'a.zip')]]))).toEqual({ names: [], known: [] });
  expect(notices.current.at(-1)!.text).toMatch(/^a\.zip: The file is cut short or damaged/);
});

test('names of files are told short', async () => {
  const long = 'x'.repeat(60_000);
  for (const name of [`${long}.txt`, `${long}.obj`, `${long}.glb`, `${long}.gltf`, `${long}.png`, `${long}.zip`]) {
    const { editor, notices } = editorOf();
    const files = new Map([[name, new File(['hello'], name)]]);
    const said = await importFiles(editor, files).then(
      () => notices.current.map(({ text }) => text).join('\n'),
      (error: Error) => error.message,
    );
    expect(said.length, name.slice(-5)).toBeGreaterThan(20);
    expect(said.length, name.slice(-5)).toBeLessThan(600);
  }
});

test('many files of one size, of which none is there, and of one name are taken in time that grows with them alone', async () => {
  const { editor, document } = editorOf();
  const size = 2 ** 20;
  const bytes = (i: number): Uint8Array<ArrayBuffer> => {
    const all = new Uint8Array(size).fill(32);
    all.set(new TextEncoder().encode(ply));
    all.set(new TextEncoder().encode(`${i}`), size - 8);
    return all;
  };
  const read = vi.spyOn(Blob.prototype, 'arrayBuffer');
  const count = 40;
  const files = new Map(
    Array.from({ length: count }, (_, i) => [`folder ${i}/triangle.ply`, new File([bytes(i)], 'triangle.ply')]),
  );
  const { names } = await importFiles(editor, files);
  expect(new Set(names).size).toBe(count);
  expect(document.assets.has(`triangle ${count}.ply`)).toBe(true);
  // a file is read to load it and to compare it with assets of its size, not with every other file
  expect(read.mock.calls.length).toBeLessThan(count * 4);
  read.mockRestore();
});

/** Messages shown when files are imported. */
async function saidOf(files: Record<string, BlobPart>): Promise<string[]> {
  const { editor, document, notices } = editorOf();
  document.onAssetFailed = ({ message }) => notices.show('error', message);
  const map = new Map(Object.entries(files).map(([path, content]) => [path, new File([content], path)]));
  const error = await importFiles(editor, map).then(
    () => [],
    ({ message }: Error) => [message],
  );
  return [...notices.current.map(({ text }) => text), ...error];
}

test.each(['glb', 'gltf', 'fbx', 'obj', 'stl', 'ply', 'png', 'hdr', 'exr', 'ktx2', 'wav', 'ies', 'cube', 'bake'])(
  'an empty .%s is told once, as that',
  async (ending) => {
    const name = `a.${ending}`;
    expect(await saidOf({ [name]: '' })).toEqual([`${name} cannot be imported: the file is empty: choose it again.`]);
  },
);

test('pictures of another ending are told as what they are', async () => {
  const png = new Uint8Array([0x89, ...new TextEncoder().encode('PNG\r\n\x1a\nand more')]);
  for (const name of ['a.glb', 'a.gltf'])
    expect(await saidOf({ [name]: png })).toEqual([
      `${name} cannot be imported: its bytes are PNG, not glTF: was another file renamed?`,
    ]);
  expect(await saidOf({ 'a.fbx': png })).toEqual([
    'a.fbx cannot be imported: its bytes are PNG, not FBX: was another file renamed?',
  ]);
  expect(await saidOf({ 'a.png': 'glTF' })).toEqual([
    'a.png cannot be imported: its bytes are not PNG, JPEG or WebP: was another file renamed?',
  ]);
});

test('nothing to import is told, and so is what was left out', async () => {
  const nothing = ['There is nothing to import: the folder or ZIP is empty.'];
  expect(await saidOf({})).toEqual(nothing);
  const end = new Uint8Array(22);
  end.set([0x50, 0x4b, 5, 6]);
  expect(await saidOf({ 'empty.zip': end })).toEqual(nothing);
  const [left] = await saidOf({ 'a.ply': ply, 'photo.psd': 'x', 'film.mp4': 'x' });
  expect(left).toMatch(/^photo\.psd, film\.mp4 cannot be imported: only \.glb/);
  // unrelated files in a folder with models are ignored silently
  expect(await saidOf({ 'rock/a.ply': ply, 'rock/license.txt': 'x' })).toEqual([]);
});

test('of many files that are left out the first ones are named, and the others counted', async () => {
  const { editor, notices } = editorOf();
  const texts = Array.from({ length: 12 }, (_, i): [string, File] => [`note${i}.txt`, new File(['x'], `note${i}.txt`)]);
  await importFiles(editor, new Map([...filesOf('triangle.ply'), ...texts]));
  expect(notices.current.map(({ text }) => text)).toEqual([
    expect.stringMatching(/^note0\.txt, .*note7\.txt and 4 more cannot be imported/),
  ]);
});
