import { type Command, countLabel, t } from '@farol/editing';
import { type FieldAssetType, GameObject, type Scene, type TakenAsset } from '@farol/engine';
import { type FieldValue, sameValue } from '@farol/engine/fields';
import {
  assetInFile,
  FILE_VERSION,
  type FileAsset,
  FileError,
  type FileObject,
  makeObjects,
  parseFile,
  serializeObject,
} from '@farol/engine/files';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { freeAssetName } from './assetNames';
import { AddAssets } from './commands/AddAssets';
import { childrenOf, type Container, topmost } from './commands/Placement';
import { PlaceObjects } from './commands/PlaceObjects';
import { Sequence } from './commands/Sequence';
import { nameUniquely } from './UniqueNames';

/** Copied GameObjects as JSON data: what the clipboard holds. */
export interface Clip {
  readonly format: 'farol-objects';
  /** In tree order; those that were copied have no parent. */
  readonly objects: readonly FileObject[];
  readonly assets: readonly FileAsset[];
  /** Where each of those without a parent was in the world: 16 numbers, column by column. */
  readonly worlds: readonly (readonly number[])[];
}

const matrix = new Matrix4();
const position = new Vector3();
const rotation = new Quaternion();
const scale = new Vector3();

/** Copies objects with all below them, as they are authored. */
export function copyObjects(scene: Scene, objects: readonly GameObject[]): string {
  const tops = topmost(objects, scene);
  const list: FileObject[] = [];
  for (const top of tops) {
    top.traverse((object) =>
      list.push(object === top ? { ...serializeObject(object), parent: null } : serializeObject(object)),
    );
  }
  const names = new Set<string>();
  for (const { components } of list) {
    for (const { type, values } of components) {
      const fields = scene.registry.fieldsOf(type);
      for (const [name, value] of Object.entries(values)) {
        if (fields[name]?.kind === 'asset' && typeof value === 'string') names.add(value);
      }
    }
  }
  const assets = [...names].flatMap((name): FileAsset[] => {
    const url = scene.assets.urlOf(name);
    const type = scene.assets.typeOf(name);
    const asset = scene.assets.fieldAsset(name);
    if (asset) return [assetInFile(asset)];
    return url && type ? [{ name, type, url }] : [];
  });
  const worlds = tops.map(({ transform }) => transform.modelMatrix.toArray());
  return JSON.stringify({ format: 'farol-objects', objects: list, assets, worlds } satisfies Clip);
}

/** Whether a text may be copied GameObjects. */
export const isClip = (text: string | null): text is string =>
  text !== null && text.startsWith('{"format":"farol-objects"');

/** References to objects that are not among those copied, which are taken out: object, component, field and value. */
function takeOuterReferences(objects: FileObject[], scene: Scene): [string, number, string, FieldValue][] {
  const ids = new Set(objects.map(({ id }) => id));
  const taken: [string, number, string, FieldValue][] = [];
  for (const { id, components } of objects) {
    components.forEach(({ type, values }, i) => {
      const fields = scene.registry.types.get(type)?.fields ?? {};
      for (const [name, value] of Object.entries(values)) {
        if (fields[name]?.kind !== 'object' || typeof value !== 'string' || ids.has(value)) continue;
        if (scene.findById(value)) taken.push([id, i, name, value]);
        delete values[name];
      }
    });
  }
  return taken;
}

/**
 * The assets made of fields of a clip that the scene does not have, ready to be added. One whose name the scene has for another
 * one gets a name of its own, which the objects are told.
 */
function takeFieldAssets(scene: Scene, list: readonly FileAsset[], objects: readonly FileObject[]): TakenAsset[] {
  const { assets } = scene;
  const names = new Map<string, string>();
  const taken = list.flatMap(({ name, type, values }): TakenAsset[] => {
    if (!values) return [];
    const known = assets.fieldAsset(name);
    if (known && sameValues(known.changedValues(), values)) return [];
    const free = freeAssetName(assets, name);
    names.set(name, free);
    assets.addFieldAsset(type as FieldAssetType, free, values);
    return [assets.take(free)];
  });
  for (const { components } of names.size > 0 ? objects : []) {
    for (const { type, values } of components) {
      const fields = scene.registry.fieldsOf(type);
      for (const [field, value] of Object.entries(values)) {
        const isMaterial = fields[field]?.kind === 'asset' && typeof value === 'string';
        if (isMaterial && names.has(value)) values[field] = names.get(value)!;
      }
    }
  }
  return taken;
}

const sameValues = (a: Readonly<Record<string, FieldValue>>, b: Readonly<Record<string, FieldValue>>): boolean =>
  Object.keys(a).length === Object.keys(b).length &&
  Object.keys(a).every((name) => name in b && sameValue(a[name], b[name]));

/** Gives an object the place in the world that it had, as seen from a parent. */
function placeInWorld(object: GameObject, world: readonly number[], parent: Container): void {
  matrix.fromArray(world);
  if (parent instanceof GameObject) matrix.premultiply(parent.transform.modelMatrix.invert());
  matrix.decompose(position, rotation, scale);
  object.transform.position = position.toArray();
  object.transform.setQuaternion(rotation);
  object.transform.scale = scale.toArray();
}

/**
 * Puts copied objects below a parent, where they were in the world, with ids and names of their own, and selects them. All of the
 * text is checked first.
 * @param parent - for objects whose parent is still the same, their authored values stay to the last digit
 * @param place - moves the copies, which are in no scene yet, to another place
 * @throws FileError listing what is wrong with the text; nothing has changed then
 */
export function pasteObjects(
  scene: Scene,
  text: string,
  parent: Container,
  selected: readonly string[],
  place: (copies: readonly GameObject[]) => void = () => {},
): Command {
  let clip: { objects?: FileObject[]; assets?: FileAsset[]; worlds?: number[][] };
  try {
    clip = JSON.parse(text) as typeof clip;
  } catch (cause) {
    throw new FileError([{ path: '', problem: t('The clipboard holds no objects: copy some first.') }], { cause });
  }
  const objects = Array.isArray(clip.objects) ? clip.objects.filter((each) => Array.isArray(each?.components)) : [];
  const outer = takeOuterReferences(objects, scene);
  // of a prefab that this scene does not have, there is the copy alone
  const prefabs = new Set(scene.prefabs.list.map(({ id }) => id));
  for (const object of objects) if (object.prefab && !prefabs.has(object.prefab.prefab)) delete object.prefab;
  const file = parseFile(
    {
      format: 'farol-scene',
      version: FILE_VERSION,
      name: 'Clipboard',
      activeCamera: null,
      assets: clip.assets ?? [],
      prefabs: scene.prefabs.list,
      objects,
    },
    { registry: scene.registry, assets: scene.assets },
  );
  for (const { name, url, type } of file.assets) {
    if (url !== undefined && !scene.assets.has(name)) scene.assets.registerUrl(name, url, type);
  }
  const materials = takeFieldAssets(scene, file.assets, file.objects);
  const made = makeObjects(file.objects, scene.registry);
  for (const [id, component, name, value] of outer) {
    for (const root of made) root.find(id)?.components[component]?.set(name, value);
  }
  const copies = made.map((root) => root.clone());
  copies.forEach((copy, i) => {
    const world = clip.worlds?.[i];
    const before = scene.findById(made[i].id);
    const isHome = before && (before.parent ?? scene) === parent;
    if (!isHome && Array.isArray(world) && world.length === 16) placeInWorld(copy, world, parent);
  });
  for (const root of made) root.dispose();
  place(copies);
  const label = countLabel(t('Pasted'), copies);
  nameUniquely(scene, copies);
  const end = childrenOf(parent).length;
  const placements = copies.map((object, i) => ({ object, parent, index: end + i }));
  const selection = { done: copies.map(({ id }) => id), undone: selected };
  const add = new PlaceObjects(label, scene, 'add', placements, selection);
  if (materials.length === 0) return add;
  return new Sequence(label, [() => new AddAssets(scene.assets, materials), () => add], selection);
}
