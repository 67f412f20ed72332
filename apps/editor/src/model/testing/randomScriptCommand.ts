import { type Command, SetFields } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import { deleteAsset } from '../assetUsages';
import type { EditorDocument } from '../EditorDocument';
import { addScript, addScriptComponent, duplicateScript, renameAnyAsset } from '../scriptEdits';
import { below, pick, type Random } from './random';

/** A random edit of the scripts: adds, edits, renames, moves, copies or removes one. */
export function randomScriptCommand(random: Random, { assets, scene }: EditorDocument, users: GameObject[]): Command {
  const scripts = assets.fieldAssets('script');
  const act = below(random, 6);
  if (scripts.length < 2 || act === 0) {
    return addScript(scene, `Script ${below(random, 20)}`, random() < 0.5 ? users : []).command;
  }
  const script = pick(random, scripts);
  if (scripts.length > 6 || act === 1) return deleteAsset(scene, script.name);
  if (act === 2) return duplicateScript(scene, script.name).command;
  if (act === 3) return addScriptComponent(scene, users, script.name);
  if (act === 4) {
    const folder = random() < 0.3 ? 'Scripts/' : '';
    const name = `${folder}Renamed ${below(random, 1000)}`;
    return renameAnyAsset(scene, script.name, assets.has(name) ? script.name : name);
  }
  const value = `import { component } from '@farol/engine/fields';
export default class Any extends component({}) {} // ${below(random, 1000)}`;
  return new SetFields('Edit script', [{ owner: script, name: 'source', value }]);
}
