import { type Command, namesOf, SetFields, t } from '@farol/editing';
import { AssetError, type Component, type FieldAsset, type GameObject, type Scene } from '@farol/engine';
import { makeUnknownComponent, UnknownComponent } from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';
import { typeNameOf } from '@farol/engine/scripts';
import { newFieldAsset, renameAsset } from './assetEdits';
import { AddAssets } from './commands/AddAssets';
import { PlaceComponents } from './commands/PlaceComponents';
import { Sequence } from './commands/Sequence';
import { SetPrefab } from './commands/SetPrefab';
import { componentName } from './componentName';
import { addComponent } from './edits';
import { setSources, sourcesAfterRename } from './scriptImports';
import { componentTypeOf, scriptOfType, sourceForName } from './scriptNames';
import { scriptTemplate } from './scriptTemplate';
import { retypeTracks } from './timeline/followTracks';

/** A command that makes a script, and the script's name, which is free. */
export interface MadeScript {
  readonly command: Command;
  readonly name: string;
}

function scriptOf(scene: Scene, name: string): FieldAsset {
  const script = scene.assets.fieldAsset(name);
  if (script?.type !== 'script') throw new AssetError(name, t('is no script.'));
  return script;
}

/**
 * Adds a script.
 * @param wanted - its name, its folder in it; it gets a number where that is taken
 * @param users - objects that get a component of it, in the same step
 */
export function addScript(scene: Scene, wanted: string, users: readonly GameObject[] = []): MadeScript {
  const { assets } = scene;
  const name = freeScriptName(scene, wanted);
  const made = newFieldAsset(assets, 'script', name, { source: scriptTemplate(name) });
  const label =
    users.length === 0
      ? t('Made script {name}', { name })
      : t('Made script {name} for {objects}', { name, objects: namesOf(users) });
  const make = [() => new AddAssets(assets, [made])];
  if (users.length === 0) return { name, command: new Sequence(label, make) };
  return { name, command: new Sequence(label, [...make, () => addScriptComponent(scene, users, name)]) };
}

/** A name that no asset has, and no type of components either. */
function freeScriptName(scene: Scene, wanted: string): string {
  const isTaken = (name: string): boolean => {
    const type = typeNameOf(name);
    return scene.assets.has(name) || scene.registry.types.has(type) || scriptOfType(scene, type) !== null;
  };
  const [, root, number = '1', ending = ''] = /^(.*?)(?: (\d+))?(\.(?:m?js|ts))?$/.exec(wanted)!;
  let name = wanted;
  for (let n = Number(number) + 1; isTaken(name); n++) name = `${root} ${n}${ending}`;
  return name;
}

/** A copy of a script in the same folder, its class called after it. @throws AssetError when it is no script */
export function duplicateScript(scene: Scene, from: string): MadeScript {
  const { assets } = scene;
  const source = scriptOf(scene, from).get('source') as string;
  const name = freeScriptName(scene, from);
  const made = newFieldAsset(assets, 'script', name, { source: sourceForName(source, from, name) });
  return {
    name,
    command: new Sequence(t('Duplicated {name}', { name: from }), [() => new AddAssets(assets, [made])]),
  };
}

/**
 * Gives a script another name, its folder in it. Its class gets the name where it is called after the script, imports of it
 * and its own lead where they did, and its components follow in prefabs and where they are kept as data; those that run
 * follow by themselves. Triggers that call them and tracks of clips follow, too.
 * @throws AssetError when the name is taken
 */
export function renameScript(scene: Scene, from: string, to: string): Command {
  const script = scriptOf(scene, from);
  const rename = renameAsset(scene, from, to);
  const { label } = rename;
  const before = script.get('source') as string;
  const source = sourceForName(before, from, to);
  const typeBefore = componentTypeOf(from, before);
  const typeAfter = componentTypeOf(to, source);
  const sources = sourcesAfterRename(scene, new Map([[from, to]]), new Map([[from, source]]));
  const isSame = typeBefore === null || typeAfter === null || typeBefore === typeAfter;
  return new Sequence(label, [
    () => rename,
    ...setSources(scene, label, sources),
    ...(isSame ? [] : retype(scene, label, typeBefore, typeAfter)),
  ]);
}

/** Gives an asset another name, whatever it is. @throws AssetError when the name is taken */
export const renameAnyAsset = (scene: Scene, from: string, to: string): Command =>
  (scene.assets.fieldAsset(from)?.type === 'script' ? renameScript : renameAsset)(scene, from, to);

/** What a trigger calls once a type has another name. @param method - 'Door.open' */
const retypedCall = (method: unknown, from: string, to: string): unknown =>
  typeof method === 'string' && method.startsWith(`${from}.`) ? to + method.slice(from.length) : method;

/** Triggers of the scene that call components of a type, and tracks of clips, go over to another type. */
function retypeUses(scene: Scene, label: string, from: string, to: string): (() => Command)[] {
  const calls = scene.componentsOf('EventTrigger').flatMap((owner) => {
    const before = owner.getAuthored('method');
    const value = retypedCall(before, from, to) as string;
    return value === before ? [] : [{ owner, name: 'method', value }];
  });
  const commands = retypeTracks(label, scene, from, to);
  if (calls.length > 0) commands.push(new SetFields(label, calls));
  return commands.map((command) => () => command);
}

/** Makes data of components, in prefabs and in the scene, those of another type; and what names the type. */
function retype(scene: Scene, label: string, from: string, to: string): (() => Command)[] {
  const prefabs = scene.prefabs.list.flatMap((prefab) => renamedType(prefab, from, to) ?? []);
  const kept: Component[] = [];
  scene.traverse(({ components }) => {
    for (const each of components) if (each instanceof UnknownComponent && each.typeName === from) kept.push(each);
  });
  const changes = [
    ...prefabs.map((prefab) => (): Command => new SetPrefab(scene, prefab.id, prefab)),
    ...retypeUses(scene, label, from, to),
  ];
  if (kept.length === 0) return changes;
  const places = kept.map((component) => {
    const { gameObject: object, id } = component;
    return { component, object, index: object.components.indexOf(component), id };
  });
  const others = places.map(({ component, ...place }) => {
    const { version } = component.componentClass;
    const values = component.authoredValues();
    return { ...place, component: makeUnknownComponent({ type: to, version, values }) };
  });
  return [
    ...changes,
    () => new PlaceComponents(label, scene, 'remove', places),
    () => new PlaceComponents(label, scene, 'add', others),
  ];
}

/** A prefab with another name of a type of components; null where nothing in it names that type. */
function renamedType(prefab: Prefab, from: string, to: string): Prefab | null {
  let isSame = true;
  const objects = prefab.objects.map((object) => ({
    ...object,
    components: object.components.map((component) => {
      const { type, values } = component;
      const method = (type === 'EventTrigger' ? retypedCall(values.method, from, to) : values.method) as string;
      if (type !== from && method === values.method) return component;
      isSame = false;
      return type === from ? { ...component, type: to } : { ...component, values: { ...values, method } };
    }),
  }));
  return isSame ? null : { ...prefab, objects };
}

/**
 * Puts a component of a script on each object. While the script does not run, that is data, which becomes the component once
 * it does.
 * @throws AssetError when the script is none of components
 */
export function addScriptComponent(scene: Scene, objects: readonly GameObject[], script: string): Command {
  const source = scriptOf(scene, script).get('source') as string;
  const type = componentTypeOf(script, source);
  if (type === null) throw new AssetError(script, t('has no component: it exports no class by default.'));
  const known = scene.registry.types.get(type);
  if (known) return addComponent(scene, objects, known);
  const places = objects.map((object) => ({
    component: makeUnknownComponent({ type, version: 1, values: {} }),
    object,
    index: object.components.length,
  }));
  const label = t('Added {component} to {name}', { component: componentName(type), name: namesOf(objects) });
  return new PlaceComponents(label, scene, 'add', places);
}
