import type { Command } from '@farol/editing';
import { DataTexture } from 'three';
import { deleteAsset } from '../assetUsages';
import { AddAssets } from '../commands/AddAssets';
import type { EditorDocument } from '../EditorDocument';
import { below, pick, type Random } from './random';

/** Names of the textures imported by `randomAssetCommand`. */
export const importedTextures = ({ assets }: EditorDocument): string[] =>
  assets.list('texture').filter((name) => !assets.isBuiltin(name));

/** Imports a texture, or deletes one with every reference to it. */
export function randomAssetCommand(random: Random, document: EditorDocument): Command {
  const { assets, scene } = document;
  const imported = importedTextures(document);
  if (imported.length > 3 || (imported.length > 0 && random() < 0.5)) return deleteAsset(scene, pick(random, imported));
  let name = '';
  do name = `imported ${below(random, 1000)}`;
  while (assets.has(name));
  assets.register(name, new DataTexture());
  return new AddAssets(assets, [assets.take(name)]);
}
