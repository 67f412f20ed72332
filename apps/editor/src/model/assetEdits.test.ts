import { CommandStack } from '@farol/editing';
import { Animation, GameObject, Light, Model, ModelRenderer, ObjectRenderer, Scene } from '@farol/engine';
import { serialize } from '@farol/engine/files';
import { makePrefab } from '@farol/engine/prefabs';
import { AnimationClip, BoxGeometry, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, PointLight } from 'three';
import { describe, expect, it } from 'vitest';
import {
  addFolder,
  addMaterial,
  duplicateMaterial,
  foldersOf,
  moveAssets,
  removeFolder,
  renameAsset,
  renameFolder,
  valuesOfOwnMaterial,
} from './assetEdits';
import { freeAssetName } from './assetNames';
import { usagesOf } from './assetUsages';
import { copyObjects, pasteObjects } from './clip';
import { EditorDocument } from './EditorDocument';
import { unpackModels, whatStaysLinked } from './unpackModels';

const state = (scene: Scene): string =>
  JSON.stringify([serialize(scene), scene.assets.list().toSorted(), scene.assets.folders]);

/** Runs a command, then undoes and redoes it: the state must come back exactly. */
function run(document: EditorDocument, command: Parameters<CommandStack['run']>[0]): void {
  const before = state(document.scene);
  document.commands.run(command);
  const after = state(document.scene);
  expect(after).not.toBe(before);
  document.commands.undo();
  expect(state(document.scene)).toBe(before);
  document.commands.redo();
  expect(state(document.scene)).toBe(after);
}

function walls() {
  const document = new EditorDocument();
  const renderers = ['One', 'Two'].map((name) => {
    const object = new GameObject(name);
    document.scene.add(object);
    return object.addComponent(ObjectRenderer, { colour: [1, 0, 0], roughness: 0.2, map: 'brick', repeat: 3 });
  });
  return { document, scene: document.scene, renderers };
}

describe('a material', () => {
  it('is made of an object, looks as it did, and is shared', () => {
    const { document, scene, renderers } = walls();
    const before = (renderers[0].three as Mesh).material as MeshStandardMaterial;
    const { command, name } = addMaterial(scene, 'Wall', valuesOfOwnMaterial(renderers[0]), renderers);
    const look = [before.color.toArray(), before.roughness, before.map!.repeat.toArray()];
    run(document, command);
    const after = (renderers[1].three as Mesh).material as MeshStandardMaterial;
    expect([after.color.toArray(), after.roughness, after.map!.repeat.toArray()]).toEqual(look);
    expect(after).toBe((renderers[0].three as Mesh).material);
    expect(usagesOf(scene, name).map(({ place, field }) => `${place} ${field}`)).toEqual([
      'One ObjectRenderer.material',
      'Two ObjectRenderer.material',
    ]);
    const copy = duplicateMaterial(scene, name);
    run(document, copy.command);
    expect(scene.assets.materialAsset(copy.name)!.changedValues()).toEqual(
      scene.assets.materialAsset(name)!.changedValues(),
    );
  });

  it('gets another name in objects, prefabs and folders', () => {
    const { document, scene, renderers } = walls();
    document.commands.run(addMaterial(scene, 'Wall', {}, renderers).command);
    const { prefab } = makePrefab(renderers[0].gameObject);
    scene.prefabs.set(prefab);
    run(document, renameAsset(scene, 'Wall', 'House/Wall of brick'));
    expect(renderers[1].material).toBe('House/Wall of brick');
    expect(JSON.stringify(scene.prefabs.list)).toContain('House/Wall of brick');
    expect(foldersOf(scene)).toEqual(['House']);
    run(document, renameFolder(scene, 'House', 'Town/House'));
    run(document, addFolder(scene, 'Town/Empty'));
    expect(foldersOf(scene)).toEqual(['Town', 'Town/Empty', 'Town/House']);
    expect(() => removeFolder(scene, 'Town')).toThrow("'Town' holds an asset: move or delete it first.");
    run(document, moveAssets(scene, ['Town/House/Wall of brick'], ''));
    expect(renderers[0].material).toBe('Wall of brick');
    run(document, removeFolder(scene, 'Town'));
    expect(() => renameAsset(scene, 'Wall of brick', 'box')).toThrow("'box' is there already");
    expect(() => renameAsset(scene, 'Wall of brick', 'a//b')).toThrow('needs a name');
  });

  it('stands in folders beside prefabs, which are moved, renamed and kept with them', () => {
    const { document, scene, renderers } = walls();
    const { prefab } = makePrefab(renderers[0].gameObject);
    scene.prefabs.set(prefab);
    document.commands.run(addMaterial(scene, 'Wall', {}, []).command);
    const names = (): unknown[] => [
      scene.prefabs.get(prefab.id)!.name,
      ...scene.assets.materialAssets.map(({ name }) => name),
    ];
    run(document, moveAssets(scene, [prefab.id, 'Wall'], 'House'));
    expect(foldersOf(scene)).toEqual(['House']);
    expect(names()).toEqual(['House/One', 'House/Wall']);
    run(document, renameFolder(scene, 'House', 'Town'));
    expect(names()).toEqual(['Town/One', 'Town/Wall']);
    run(document, moveAssets(scene, ['Town/Wall'], ''));
    expect(() => removeFolder(scene, 'Town')).toThrow("'Town' holds an asset: move or delete it first.");
    document.commands.undo();
    document.commands.undo();
    document.commands.undo();
    expect(scene.prefabs.get(prefab.id)!.name).toBe('One');
  });

  it('comes along with what is pasted, once', () => {
    const { scene, renderers, document } = walls();
    document.commands.run(addMaterial(scene, 'Wall', { roughness: 0.9 }, renderers).command);
    const clip = copyObjects(scene, [renderers[0].gameObject]).text;
    const other = new EditorDocument();
    run(other, pasteObjects(other.scene, clip, other.scene, []));
    expect(other.assets.materialAsset('Wall')!.get('roughness')).toBe(0.9);
    // an equal asset is shared, a different one of that name is renamed
    run(other, pasteObjects(other.scene, clip, other.scene, []));
    expect(other.assets.materialAssets).toHaveLength(1);
    other.assets.materialAsset('Wall')!.set('roughness', 0.1);
    run(other, pasteObjects(other.scene, clip, other.scene, []));
    expect(other.scene.componentsOf(ObjectRenderer).map(({ material }) => material)).toEqual([
      'Wall',
      'Wall',
      'Wall 2',
    ]);
  });
});

it('a free name counts on, before the ending', () => {
  const { scene } = walls();
  scene.assets.addMaterial('Props/Wall');
  scene.assets.addMaterial('Props/Wall 2');
  scene.assets.registerFile('a.ply.gz', new Blob());
  expect(freeAssetName(scene.assets, 'Props/Wall')).toBe('Props/Wall 3');
  expect(freeAssetName(scene.assets, 'a.ply.gz')).toBe('a 2.ply.gz');
  expect(freeAssetName(scene.assets, 'b.png')).toBe('b.png');
});

describe('unpacking a model', () => {
  function morphed(name: string): Mesh {
    const geometry = new BoxGeometry();
    geometry.morphAttributes.position = [geometry.getAttribute('position').clone()];
    const mesh = new Mesh(geometry, new MeshBasicMaterial());
    mesh.name = name;
    return mesh;
  }

  function placed(extra?: Mesh, isAlone = false) {
    const root = new Group();
    const mesh = new Mesh(new BoxGeometry(), new MeshStandardMaterial({ name: 'Red', color: 0xff0000 }));
    mesh.name = 'Body';
    if (!isAlone) root.add(mesh, new PointLight(0xffffff, 5));
    if (extra) root.add(extra);
    const document = new EditorDocument();
    const { assets, scene } = document;
    const model = new Model(root, [new AnimationClip('Turn', 1, [])]);
    assets.register('Props/robot.glb', model);
    assets.register('Props/robot.glb/mesh-1', mesh.geometry);
    assets.register('Props/robot.glb/clip-1-Turn', assets.model('Props/robot.glb').clips[0]);
    const object = new GameObject('Robot');
    scene.add(object);
    const renderer = object.addComponent(ModelRenderer, {
      model: 'Props/robot.glb',
      animation: 'Turn',
      castShadow: false,
    });
    return { document, scene, object, renderer };
  }

  it('is one step: objects, a light, a material as an asset, an Animation with its clip', () => {
    const { document, scene, object, renderer } = placed();
    run(document, unpackModels(scene, [renderer]));
    expect(document.commands.history.length).toBe(1);
    expect(object.getComponent(ModelRenderer)).toBeNull();
    expect(object.getComponent(Animation)).toMatchObject({ clip: 'Props/robot.glb/clip-1-Turn', speed: 1 });
    const body = object.find('Body')!.getComponent(ObjectRenderer)!;
    expect(body).toMatchObject({ mesh: 'Props/robot.glb/mesh-1', material: 'Props/robot/Red', castShadow: false });
    expect(scene.assets.materialAsset('Props/robot/Red')!.get('colour')).toEqual([1, 0, 0]);
    expect(scene.componentsOf(Light)).toHaveLength(1);
    expect(document.selection.ids).toEqual([object.id]);
  });

  it('is refused, with the reason, where something would be lost', () => {
    const { scene, renderer } = placed(morphed('Face'), true);
    expect(() => unpackModels(scene, [renderer])).toThrow(
      'Props/robot.glb stays one object: it has morph targets, which only a whole model keeps.',
    );
  });

  it('keeps parts that only a model has as objects linked to it, says which, and does not unpack them again', () => {
    const { document, scene, object, renderer } = placed(morphed('Face'));
    run(document, unpackModels(scene, [renderer]));
    const face = object.find('Face')!.getComponent(ModelRenderer)!;
    expect(face).toMatchObject({ model: 'Props/robot.glb', parts: 'Face', castShadow: false });
    expect(object.find('Body')!.getComponent(ObjectRenderer)).not.toBeNull();
    expect(whatStaysLinked(scene.assets, ['Props/robot.glb'])).toBe(
      '“Face” stays linked to the model, as one object with its clips: it has morph targets.',
    );
    expect(() => unpackModels(scene, [face])).toThrow('(Face) stays one object: it has morph targets');
  });
});
