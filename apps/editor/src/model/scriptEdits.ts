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

/** A command that adds a script, and the script's name. */
export interface MadeScript {
  readonly command: Command;
  readonly name: string;
}

function scriptOf(scene: Scene, name: string): FieldAsset {
  const script = scene.assets.fieldAsset(name);
  if (script?.type !== 'script') throw new AssetError(name, t('is not a script.'));
  return script;
}

/** Text of a script, and the component type that it defines. */
export interface ScriptText {
  readonly type: string;
  readonly source: string;
}

/**
 * Adds a script.
 * @param wanted - proposed name, with folder; a number is added when it is taken
 * @param users - objects that get a component of the script, in the same step
 * @param template - text of the new script, its class renamed; `scriptTemplate` when absent
 */
export function addScript(
  scene: Scene,
  wanted: string,
  users: readonly GameObject[] = [],
  template?: ScriptText,
): MadeScript {
  const { assets } = scene;
  const name = freeScriptName(scene, wanted);
  const source = template ? sourceForName(template.source, template.type, name) : scriptTemplate(name);
  const made = newFieldAsset(assets, 'script', name, { source });
  const label =
    users.length === 0
      ? t('Made script {name}', { name })
      : t('Made script {name} for {objects}', { name, objects: namesOf(users) });
  const make = [() => new AddAssets(assets, [made])];
  if (users.length === 0) return { name, command: new Sequence(label, make) };
  return { name, command: new Sequence(label, [...make, () => addScriptComponent(scene, users, name)]) };
}

/** A name taken neither by an asset nor by a component type. */
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

/** Copies a script in the same folder, and renames its class after it. @throws AssetError when it is no script */
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
 * Renames a script; the name includes its folder. A class named after the script is renamed too. Imports of and by the
 * script are adapted, and so are triggers that call its components, tracks of clips, and its components in prefabs or
 * kept as data while it does not run; those that run adapt by themselves.
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

/** Renames an asset of any type. @throws AssetError when the name is taken */
export const renameAnyAsset = (scene: Scene, from: string, to: string): Command =>
  (scene.assets.fieldAsset(from)?.type === 'script' ? renameScript : renameAsset)(scene, from, to);

/** The method that a trigger calls, with a renamed component type. @param method - such as 'Door.open' */
const retypedCall = (method: unknown, from: string, to: string): unknown =>
  typeof method === 'string' && method.startsWith(`${from}.`) ? to + method.slice(from.length) : method;

/** Renames a component type in the scene's triggers and in tracks of clips. */
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

/** Renames a component type in prefabs, in components kept as data, in triggers that call it and in tracks of clips. */
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

/** A prefab with a component type renamed; null when it has no component of that type. */
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
 * Adds a component of a script to each object. Until the script runs, only the component's data are kept, without
 * behaviour.
 * @throws AssetError when the script defines no component
 */
export function addScriptComponent(scene: Scene, objects: readonly GameObject[], script: string): Command {
  const source = scriptOf(scene, script).get('source') as string;
  const type = componentTypeOf(script, source);
  if (type === null) throw new AssetError(script, t('has no component: export its class by default.'));
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
