import { type Command, namesOf, t } from '@farol/editing';
import type { GameObject, Scene } from '@farol/engine';
import { bringAssets } from '../bringAssets';
import { AddAssets } from '../commands/AddAssets';
import { Sequence } from '../commands/Sequence';
import { addScriptComponent } from '../scriptEdits';
import { scriptAsset } from './parts';

/** Adds a component of one of the library's scripts to objects; also the script, when the scene lacks it. */
export function addLibraryScript(scene: Scene, objects: readonly GameObject[], type: string): Command {
  const asset = scriptAsset(type);
  const { taken, names } = bringAssets(scene, [asset], new Map());
  const use = (): Command => addScriptComponent(scene, objects, names.get(asset.name) ?? asset.name);
  const steps = taken.length > 0 ? [() => new AddAssets(scene.assets, taken), use] : [use];
  return new Sequence(t('Added {component} to {name}', { component: type, name: namesOf(objects) }), steps);
}
