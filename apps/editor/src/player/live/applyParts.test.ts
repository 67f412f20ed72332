import { AssetLibrary, builtinComponents, ComponentRegistry, createRandom, type Scene } from '@farol/engine';
import { deserialize, serialize } from '@farol/engine/files';
import { expect, it } from 'vitest';
import type { PartChange, PartKey } from '../../files/autosave/parts';
import { HEAD } from '../../files/autosave/parts';
import { SceneDelta } from '../../files/autosave/SceneDelta';
import { changesBetween, fileOfParts, splitHead } from '../../files/live/liveParts';
import { EditorDocument } from '../../model/EditorDocument';
import { randomCommand } from '../../model/testing/randomCommand';
import { randomScene } from '../../model/testing/randomScene';
import { scriptsInNode } from '../../model/testing/scriptsInNode';
import { applyParts } from './applyParts';

/** Text of a scene's file, without parts that do not affect the picture. */
function textOf(scene: Scene): string {
  const { views: _views, assetFolders: _folders, ...file } = serialize(scene);
  return JSON.stringify(file);
}

it.each([1, 2, 3])('a scene that is given the parts of random edits becomes the edited one, seed %i', async (seed) => {
  const random = createRandom(seed);
  const makeRegistry = (): ComponentRegistry =>
    new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const document = new EditorDocument(undefined, makeRegistry(), scriptsInNode());
  document.open(randomScene(random, document));
  const delta = new SceneDelta(document.scene);
  document.sceneChanged.subscribe((change) => delta.note(change));
  document.assetsChanged.subscribe(() => delta.noteAssets());
  delta.noteAll();
  const told = new Map<PartKey, string>();
  const registry = makeRegistry();
  const fileOf = (path: string): Blob | null => {
    const asset = serialize(document.scene).assets.find(({ file }) => file === path);
    return asset ? document.assets.fileOf(asset.name) : null;
  };
  let scene: Scene | null = null;
  let shown: ReadonlyMap<PartKey, string> = new Map();
  let remade = 0;
  for (let step = 0; step < 150; step++) {
    const before = new Map(told);
    for (const [key, json] of delta.read(() => false)) {
      if (key === HEAD) {
        for (const each of [...told.keys()].filter((part) => /^[ah]\//.test(part))) told.delete(each);
        for (const [part, text] of splitHead(json!, ({ file }) => file)) told.set(part, text);
      } else if (json === null) told.delete(key);
      else told.set(key, json);
    }
    shown = before;
    const changes: PartChange[] = changesBetween(shown, told);
    const isApplied =
      scene &&
      (await applyParts(scene, told, changes, registry, (path) => Promise.resolve(fileOf(path)!)).catch(() => false));
    if (!isApplied) {
      scene?.dispose();
      scene = await deserialize(fileOfParts(told), { assets: new AssetLibrary(), registry, fileOf });
      remade++;
    }
    if (textOf(scene!) !== textOf(document.scene)) {
      expect(JSON.parse(textOf(scene!)), `after '${document.commands.undoLabel}'`).toEqual(
        JSON.parse(textOf(document.scene)),
      );
    }
    if (random() < 0.2) document.commands.undo();
    else document.commands.run(randomCommand(random, document));
    // random bakes and imported textures exist only in memory, not in files
    const { bakedLight, lut } = document.scene.settings.changedValues();
    if (bakedLight || String(lut).startsWith('imported')) document.commands.undo();
    if (document.scripts.isCompiling) await document.scripts.settled();
  }
  expect(remade, 'scenes made anew').toBeLessThan(12);
});
