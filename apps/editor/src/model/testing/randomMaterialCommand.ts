import type { Command } from '@farol/editing';
import { ObjectRenderer } from '@farol/engine';
import {
  addFolder,
  addMaterial,
  canMove,
  duplicateMaterial,
  foldersOf,
  moveAssets,
  removeFolder,
  renameAsset,
  renameFolder,
  valuesOfOwnMaterial,
} from '../assetEdits';
import { assetsBelow } from '../assetEdits';
import { deleteAsset } from '../assetUsages';
import type { EditorDocument } from '../EditorDocument';
import { below, pick, type Random } from './random';
import { randomEdit } from './randomEdit';

/** A random edit of the library's materials and folders: adds, changes, renames, moves, copies or removes one. */
export function randomMaterialCommand(random: Random, document: EditorDocument): Command {
  const { assets, scene } = document;
  const materials = assets.materialAssets;
  const renderers = scene.componentsOf(ObjectRenderer);
  const folders = foldersOf(scene);
  const act = below(random, 9);
  if (materials.length < 2 || act === 0) {
    const users = renderers.filter(() => random() < 0.3);
    const values = users.length > 0 ? valuesOfOwnMaterial(users[0]) : {};
    return addMaterial(scene, `Material ${below(random, 20)}`, values, users).command;
  }
  const material = pick(random, materials);
  if (materials.length > 8 || act === 1) return deleteAsset(scene, material.name);
  if (act === 2) return duplicateMaterial(scene, material.name).command;
  if (act === 3 || folders.length === 0) {
    const path = `Folder ${below(random, 1000)}`;
    return folders.includes(path) ? randomEdit(random, document, material) : addFolder(scene, path);
  }
  const folder = pick(random, folders);
  if (act === 4) {
    const all = [...assets.list(), ...scene.prefabs.list.map(({ id }) => id)].filter((name) => canMove(scene, name));
    return moveAssets(
      scene,
      all.filter(() => random() < 0.4),
      random() < 0.3 ? '' : folder,
    );
  }
  if (act === 5) {
    const to = `Name ${below(random, 1e6)}`;
    return assets.has(to) ? randomEdit(random, document, material) : renameAsset(scene, material.name, to);
  }
  if (act === 6 && folders.length < 8) return renameFolder(scene, folder, `Folder ${1000 + below(random, 1e6)}`);
  if (act === 6 && assetsBelow(scene, folder).length === 0) return removeFolder(scene, folder);
  return randomEdit(random, document, material);
}
