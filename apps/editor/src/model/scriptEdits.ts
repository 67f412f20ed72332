import { type Command, t } from '@farol/editing';
import { AssetError, type Scene } from '@farol/engine';
import { newFieldAsset } from './assetEdits';
import { freeAssetName } from './assetNames';
import { AddAssets } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';
import { scriptTemplate, sourceForName } from './scriptTemplate';

/** A command that makes a script, and the script's name, which is free. */
export interface MadeScript {
  readonly command: Command;
  readonly name: string;
}

function addSource(scene: Scene, name: string, source: string, label: (name: string) => string): MadeScript {
  const made = newFieldAsset(scene.assets, 'script', name, { source });
  return { name: made.name, command: new Sequence(label(made.name), [() => new AddAssets(scene.assets, [made])]) };
}

/**
 * Adds a script.
 * @param wanted - its name, its folder in it; it gets a number where that is taken
 * @param source - its text; a class with one field when absent
 */
export function addScript(scene: Scene, wanted: string, source?: string): MadeScript {
  const name = freeAssetName(scene.assets, wanted);
  return addSource(scene, name, source ?? scriptTemplate(name), (made) => t('Made script {name}', { name: made }));
}

/** A copy of a script in the same folder, its class called after it. @throws AssetError when it is no script */
export function duplicateScript(scene: Scene, name: string): MadeScript {
  const script = scene.assets.fieldAsset(name);
  if (script?.type !== 'script') throw new AssetError(name, t('is no script.'));
  const free = freeAssetName(scene.assets, name);
  const source = sourceForName(script.get('source') as string, free);
  return addSource(scene, free, source, () => t('Duplicated {name}', { name }));
}
