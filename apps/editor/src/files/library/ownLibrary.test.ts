import { builtinComponents, ComponentRegistry, GameObject, ObjectRenderer, Scene } from '@farol/engine';
import { serialize } from '@farol/engine/files';
import { makePrefab } from '@farol/engine/prefabs';
import { PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import type { EditorApi } from '../../api/EditorApi';
import { Dialogs } from '../../model/Dialogs';
import { EditorDocument } from '../../model/EditorDocument';
import { itemsOfFolder, openLibraryFolder } from './ownLibrary';
import { placeLibraryItem } from './placeLibraryItem';

/** An editor that looks at the ground from above. */
function makeEditor(): EditorApi {
  const document = new EditorDocument();
  document.open(new Scene());
  const camera = new PerspectiveCamera(60, 1, 0.1, 1000);
  camera.position.set(0, 3, 8);
  camera.lookAt(new Vector3());
  camera.updateMatrixWorld();
  const viewport = {
    panes: { activateAt: () => {} },
    bounds: { left: 0, top: 0, width: 100, height: 100 },
    ...{ rayCamera: camera, editorCamera: { target: new Vector3() }, snapping: false },
  };
  return {
    ...{ document, commands: document.commands, viewport, dialogs: new Dialogs() },
    components: new ComponentRegistry(builtinComponents.types.values()),
    mayUnpack: () => Promise.resolve(true),
  } as unknown as EditorApi;
}

/** A scene file with a prefab: a red box with a material. */
function fileWithPrefab(): File {
  const scene = new Scene();
  scene.assets.addFieldAsset('material', 'Red', { colour: [1, 0, 0] });
  const box = new GameObject('Red box');
  box.addComponent(ObjectRenderer, { mesh: 'box', material: 'Red' });
  scene.add(box);
  const { prefab, links } = makePrefab(box, 'Shop/Red box');
  scene.prefabs.set(prefab);
  for (const [object, link] of links) object.prefabLink = link;
  const text = JSON.stringify(serialize(scene));
  scene.dispose();
  return new File([text], 'shop.json');
}

test('the prefabs of a folder of scenes are items; one is placed with its material, as one step', async () => {
  const editor = makeEditor();
  const { document, commands } = editor;
  const other = new File(['{}'], 'package.json');
  await expect(openLibraryFolder(editor, [other])).rejects.toThrow('No scene file of this folder has a prefab.');
  await openLibraryFolder(editor, [other, fileWithPrefab(), new File(['png'], 'Red box.png')]);
  const [item] = itemsOfFolder();
  expect([item.name, item.tags, item.picture !== null]).toEqual(['Red box', ['shop'], true]);
  await placeLibraryItem(editor, item.id);
  const { scene, assets } = document;
  const [box] = scene.roots;
  expect([box.name, box.prefabLink?.prefab, box.getComponent(ObjectRenderer)!.material]).toEqual([
    'Red box',
    item.prefab,
    'Red',
  ]);
  expect([box.transform.position[1], commands.history]).toEqual([0.5, ['Added Red box']]);
  await placeLibraryItem(editor, item.id);
  expect([scene.roots.map(({ name }) => name), scene.prefabs.list.length]).toEqual([['Red box', 'Red box 2'], 1]);
  commands.undo();
  commands.undo();
  expect([scene.roots.length, scene.prefabs.list.length, assets.fieldAssets('material').length]).toEqual([0, 0, 0]);
});
