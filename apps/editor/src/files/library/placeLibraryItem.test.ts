import { GameObject, ObjectRenderer, Room, Scene } from '@farol/engine';
import { PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import type { EditorApi } from '../../api/EditorApi';
import { EditorDocument } from '../../model/EditorDocument';
import { placeLibraryItem } from './placeLibraryItem';

type Triple = [number, number, number];

/** An editor that looks from an eye (m) at a target, its viewport 100 × 100 pixels. */
function editorAt(eye: Triple, target: Triple): EditorApi {
  const document = new EditorDocument();
  document.open(new Scene());
  const camera = new PerspectiveCamera(60, 1, 0.1, 1000);
  camera.position.fromArray(eye);
  camera.lookAt(new Vector3(...target));
  camera.updateMatrixWorld();
  const viewport = {
    panes: { activateAt: () => {} },
    bounds: { left: 0, top: 0, width: 100, height: 100 },
    ...{ rayCamera: camera, editorCamera: { target: new Vector3(...target) }, snapping: false },
  };
  return { document, commands: document.commands, viewport } as unknown as EditorApi;
}

const rounded = (values: readonly number[]): number[] => values.map((each) => Math.round(each * 100) / 100 + 0);

/** Adds an item; its position, and the direction of its front, -Z, in the world. */
async function placed(editor: EditorApi, id: string, at?: { x: number; y: number }): Promise<[number[], number[]]> {
  const { scene, selection } = editor.document;
  await placeLibraryItem(editor, id, { at });
  const { transform } = scene.findById(selection.ids[0])!;
  scene.three.updateMatrixWorld();
  return [rounded(transform.position), rounded(transform.front.toArray())];
}

/** A room of 4 × 2.6 × 4 m round the origin. */
function addRoom({ document }: EditorApi): void {
  const room = new GameObject('Room');
  room.addComponent(Room, { width: 4, depth: 4, height: 2.6, door: 'none', window: 'none' });
  room.addComponent(ObjectRenderer, { mesh: null });
  document.scene.add(room);
  document.scene.three.updateMatrixWorld();
}

test('a lamp comes with its prefab and materials as one step; another shares them; undo leaves nothing', async () => {
  const editor = editorAt([0, 3, 8], [0, 0, 0]);
  const { document, commands } = editor;
  const { scene, assets } = document;
  const materials = (): number => assets.fieldAssets('material').length;
  await placeLibraryItem(editor, 'street-lamp');
  const [first] = scene.roots;
  expect([first.name, first.prefabLink?.prefab, scene.prefabs.list.length]).toEqual([
    'Street lamp',
    'library-street-lamp',
    1,
  ]);
  expect([commands.history, materials()]).toEqual([['Added Street lamp'], 2]);
  await placeLibraryItem(editor, 'street-lamp');
  expect([scene.roots.map(({ name }) => name), scene.prefabs.list.length, materials()]).toEqual([
    ['Street lamp', 'Street lamp 2'],
    1,
    2,
  ]);
  // a lantern below it has a material of its own, and no place in the view
  await placeLibraryItem(editor, 'lantern', { parent: first });
  expect([first.children.at(-1)!.name, first.children.at(-1)!.transform.position]).toEqual(['Lantern', [0, 0, 0]]);
  for (let i = 0; i < 3; i++) commands.undo();
  expect([scene.roots.length, scene.prefabs.list.length, materials()]).toEqual([0, 0, 0]);
  commands.redo();
  expect([scene.roots[0].name, scene.prefabs.list.length, materials()]).toEqual(['Street lamp', 1, 2]);
});

test('a street lamp stands on the floor, a pendant hangs from the ceiling above, a sconce turns to its wall', async () => {
  const editor = editorAt([0, 1.6, 1.8], [0, 1.3, -2]);
  addRoom(editor);
  const floor = { x: 50, y: 80 };
  expect((await placed(editor, 'candle', floor))[0][1]).toBe(0);
  const [pendant] = await placed(editor, 'pendant', floor);
  expect(pendant[1]).toBe(2.6);
  // at the ceiling itself, and beside the first one
  const [second] = await placed(editor, 'pendant', { x: 50, y: 5 });
  expect(second[1]).toBe(2.6);
  // the wall before the eye faces +Z, the right one -X
  const [sconce, front] = await placed(editor, 'sconce');
  expect([sconce[2], front]).toEqual([-2, [0, 0, 1]]);
  const [another] = await placed(editor, 'sconce');
  expect([another[2], Math.abs(another[0] - sconce[0]) > 0.1, another[1] === sconce[1]]).toEqual([-2, true, true]);
  const [side, left] = await placed(editor, 'sconce', { x: 99, y: 50 });
  expect([side[0], left]).toEqual([2, [-1, 0, 0]]);
});

test('without a ceiling or a wall a pendant hangs at a height over the ground, and a sconce faces the eye', async () => {
  const editor = editorAt([0, 3, 8], [0, 0, 0]);
  expect((await placed(editor, 'pendant'))[0]).toEqual([0, 2.6, 0]);
  const [at, front] = await placed(editor, 'sconce');
  expect([at[1], front]).toEqual([1.6, [0, 0, 1]]);
});
