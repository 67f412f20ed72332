import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { GameObject, Light, ObjectRenderer, Room, Scene } from '@farol/engine';
import { root } from '@farol/tools/root';
import { PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import type { EditorApi } from '../../api/EditorApi';
import { EditorDocument } from '../../model/EditorDocument';
import { libraryMaterials } from '../../model/library/materials';
import { libraryNames } from '../../model/library/names';
import { pictureFile } from './libraryItems';
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

/** Adds an item. @returns its position, and the world direction of its front, -Z */
async function placed(editor: EditorApi, id: string, at?: { x: number; y: number }): Promise<[number[], number[]]> {
  const { scene, selection } = editor.document;
  await placeLibraryItem(editor, id, { at });
  const { transform } = scene.findById(selection.ids[0])!;
  scene.three.updateMatrixWorld();
  return [rounded(transform.position), rounded(transform.front.toArray())];
}

/** Adds a room of 4 × 2.6 × 4 m around the origin. */
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
  // an item below a parent gets its own material, and is not placed by the view
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
  // pointed at the ceiling: beside the first lamp
  const [second] = await placed(editor, 'pendant', { x: 50, y: 5 });
  expect(second[1]).toBe(2.6);
  // the wall in front of the eye faces +Z, the right one -X
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

test('a sky turns the sun into its own and switches off what stood for a sky; a material goes on what is selected', async () => {
  const editor = editorAt([0, 3, 8], [0, 0, 0]);
  const { document, commands } = editor;
  const { scene, assets } = document;
  const add = (name: string, type: string, values = {}): GameObject => {
    const object = new GameObject(name);
    object.addComponent(type, values);
    scene.add(object);
    return object;
  };
  const sun = add('Sun', 'Light', { type: 'directional', intensity: 2 }).getComponent(Light)!;
  const fill = add('Sky', 'Light', { type: 'hemisphere' }).getComponent(Light)!;
  const box = add('Box', 'ObjectRenderer', { mesh: 'box' }).getComponent(ObjectRenderer)!;
  await placeLibraryItem(editor, 'moonlit-night');
  expect([scene.settings.background, scene.settings.sky, fill.enabled]).toEqual(['sky', 'night', false]);
  expect([sun.castShadow, sun.intensity < 0.5, sun.direction.y < -0.4]).toEqual([true, true, true]);
  for (const sky of ['clear-day', 'sunset', 'studio']) {
    await placeLibraryItem(editor, sky);
    commands.undo();
  }
  await placeLibraryItem(editor, 'foggy-night');
  expect(scene.settings.volumetricFog).toBe(true);
  commands.undo();
  await placeLibraryItem(editor, 'overcast');
  expect([sun.enabled, scene.settings.sky]).toEqual([false, 'overcast']);
  expect(commands.history).toEqual(['Changed the sky to Moonlit night', 'Changed the sky to Overcast']);
  commands.undo();
  commands.undo();
  expect([sun.enabled, sun.intensity, fill.enabled, scene.settings.background]).toEqual([true, 2, true, 'colour']);

  await expect(placeLibraryItem(editor, 'material/Brass')).rejects.toThrow('Drop Brass on an object with a mesh');
  document.selection.set([box.gameObject.id]);
  await placeLibraryItem(editor, 'material/Brass');
  expect([box.material, commands.history]).toEqual(['Library/Brass', ['Gave Brass to Box']]);
  commands.undo();
  expect([box.material, assets.fieldAssets('material').length]).toEqual([null, 0]);
});

test('a player looks by its eyes, and gets a ground where nothing carries it; a selected lamp flickers', async () => {
  const editor = editorAt([0, 3, 8], [0, 0, 0]);
  const told: string[] = [];
  Object.assign(editor, { notices: { show: (_: string, text: string) => told.push(text) } });
  const { document, commands } = editor;
  const { scene } = document;
  // components of scripts are kept as data, since nothing compiles them here
  document.scripts.isOn = false;
  await placeLibraryItem(editor, 'player');
  expect(scene.roots.map(({ name }) => name)).toEqual(['Player', 'Ground']);
  expect([scene.activeCamera?.gameObject.name, told.length]).toEqual(['Eyes', 1]);
  expect([document.selectedObjects.map(({ name }) => name), commands.history.length]).toEqual([['Player'], 1]);
  await placeLibraryItem(editor, 'candle');
  await placeLibraryItem(editor, 'flicker');
  const candle = scene.roots[2];
  expect([candle.name, candle.components.map(({ typeName }) => typeName)]).toEqual([
    'Candle',
    ['Transform', 'Flicker'],
  ]);
  for (let i = 0; i < 3; i++) commands.undo();
  expect([scene.roots.length, scene.activeCamera, scene.assets.fieldAssets('script').length]).toEqual([0, null, 0]);
});

test('every item that draws something has its picture, and there are no others', async () => {
  const ids = [
    ...Object.values(libraryNames).flatMap((names) => Object.keys(names)),
    ...Object.keys(libraryMaterials).map((name) => `material/${name}`),
  ];
  const there = await readdir(join(root, 'public/library'));
  expect(there.toSorted()).toEqual(ids.flatMap((id) => pictureFile(id) ?? []).toSorted());
});
