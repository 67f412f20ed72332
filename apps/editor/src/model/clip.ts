import { type Command, countLabel, namesOf, t } from '@farol/editing';
import { ComponentRegistry, GameObject, type Scene } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import {
  FILE_VERSION,
  type FarolFile,
  type FileAsset,
  FileError,
  type FileObject,
  makeObjects,
  parseFile,
  type ParseOptions,
  serializeObject,
} from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';
import { Matrix4, Quaternion, Vector3 } from 'three';
import { bringAssets, nameInScene, type ReadAsset, renamedObjects } from './bringAssets';
import { AddAssets } from './commands/AddAssets';
import { childrenOf, type Container, topmost } from './commands/Placement';
import { PlaceObjects } from './commands/PlaceObjects';
import { Sequence } from './commands/Sequence';
import { SetPrefab } from './commands/SetPrefab';
import { cloneTogether } from './cloneTogether';
import { copiedAssets, type NamingFields } from './copiedAssets';
import { nameUniquely } from './UniqueNames';

/** Copied GameObjects as JSON: content of the clipboard. */
export interface Clip {
  /** Format, as the first member of the JSON text, where `Clipboard.hasObjects` looks for it. */
  readonly format: 'farol-objects';
  /** Objects in tree order; the copied roots have no parent. */
  readonly objects: readonly FileObject[];
  /** Assets, each after those that it uses; a file asset names its file in the clipboard. */
  readonly assets: readonly FileAsset[];
  /** Fields that refer to assets and objects, for each component type defined by a script. */
  readonly naming: Readonly<Record<string, NamingFields>>;
  /** Prefabs of the objects, and prefabs within these; none when absent. */
  readonly prefabs?: readonly Prefab[];
  /** World matrices of the copied roots: 16 numbers, column-major. */
  readonly worlds: readonly (readonly number[])[];
}

const matrix = new Matrix4();
const position = new Vector3();
const rotation = new Quaternion();
const scale = new Vector3();

/** Copied objects as text, and the files that the text refers to. */
export interface CopiedObjects {
  readonly text: string;
  readonly files: ReadonlyMap<string, Blob>;
}

/** Prefabs of a scene that objects are instances of, and prefabs within these. */
function prefabsOf({ prefabs }: Scene, objects: readonly FileObject[]): Prefab[] {
  const linked = (list: readonly FileObject[]): string[] => list.flatMap(({ prefab }) => prefab?.prefab ?? []);
  const ids = new Set(linked(objects));
  // a Set that grows during the loop is iterated to its end
  for (const id of ids) for (const inner of linked(prefabs.get(id)?.objects ?? [])) ids.add(inner);
  return prefabs.list.filter(({ id }) => ids.has(id));
}

/** Copies objects and their descendants with authored values, their prefabs, and the assets that all of these use. */
export function copyObjects(scene: Scene, objects: readonly GameObject[]): CopiedObjects {
  const tops = topmost(objects, scene);
  const list: FileObject[] = [];
  for (const top of tops) {
    top.traverse((object) =>
      list.push(object === top ? { ...serializeObject(object), parent: null } : serializeObject(object)),
    );
  }
  const prefabs = prefabsOf(scene, list);
  const data = [...list, ...prefabs.flatMap(({ objects: inner }) => inner)];
  const { assets, files, naming } = copiedAssets(scene, tops, data);
  const worlds = tops.map(({ transform }) => transform.modelMatrix.toArray());
  const clip: Clip = { format: 'farol-objects', objects: list, assets, naming, prefabs, worlds };
  const text = JSON.stringify(clip);
  return { text, files };
}

/**
 * Removes references to objects that were not copied. @returns those whose target is in the scene: object's id, index
 * of the component, field and value
 */
function takeOuterReferences(
  objects: FileObject[],
  scene: Scene,
  naming: Readonly<Record<string, NamingFields>>,
): [string, number, string, FieldValue][] {
  const ids = new Set(objects.map(({ id }) => id));
  const taken: [string, number, string, FieldValue][] = [];
  for (const { id, components } of objects) {
    components.forEach((component, i) => {
      const { type, values } = (component ?? {}) as Partial<typeof component>;
      // malformed data is reported when the whole text is checked
      if (typeof type !== 'string' || typeof values !== 'object' || values === null) return;
      const fields = scene.registry.types.get(type)?.fields ?? {};
      for (const [name, value] of Object.entries(values)) {
        const isReference = fields[name]?.kind === 'object' || naming[type]?.objects.includes(name);
        if (!isReference || typeof value !== 'string' || ids.has(value)) continue;
        if (scene.findById(value)) taken.push([id, i, name, value]);
        delete values[name];
      }
    });
  }
  return taken;
}

/** Prefabs of copied objects that the scene lacks; instances of prefabs that cannot be used become plain objects. */
function newPrefabs({ prefabs }: Scene, { prefabs: copied, objects }: ReturnType<typeof readClip>): Prefab[] {
  const known = new Set(prefabs.list.map(({ id }) => id));
  const list = Array.isArray(copied) ? (copied as Prefab[]).filter((each) => !known.has(each?.id)) : [];
  for (const each of list) known.add(each?.id);
  const inner = list.flatMap((each): FileObject[] => (Array.isArray(each?.objects) ? [...each.objects] : []));
  for (const object of [...objects, ...inner])
    if (object?.prefab && !known.has(object.prefab.prefab)) delete object.prefab;
  return list;
}

/** Gives an object a world matrix, below a given parent. */
function placeInWorld(object: GameObject, world: readonly number[], parent: Container): void {
  matrix.fromArray(world);
  if (parent instanceof GameObject) matrix.premultiply(parent.transform.modelMatrix.invert());
  matrix.decompose(position, rotation, scale);
  object.transform.position = position.toArray();
  object.transform.setQuaternion(rotation);
  object.transform.scale = scale.toArray();
}

/** Copied objects read from text, not yet checked. */
type RawClip = { -readonly [K in keyof Clip]?: Clip[K] };

const isTexts = (value: unknown): value is string[] =>
  Array.isArray(value) && value.every((each) => typeof each === 'string');

/** Fields that refer to assets and objects, for each type with well-formed data; only own property names count. */
function readNaming(given: unknown): Record<string, NamingFields> {
  const naming = Object.create(null) as Record<string, NamingFields>;
  for (const [type, each] of Object.entries(given ?? {})) {
    const { assets, objects } = (each ?? {}) as Partial<NamingFields>;
    if (isTexts(assets) && isTexts(objects)) naming[type] = { assets, objects };
  }
  return naming;
}

const isMatrix = (value: unknown): value is number[] =>
  Array.isArray(value) && value.length === 16 && value.every((each) => Number.isFinite(each));

function readClip(text: string): RawClip & { objects: FileObject[] } {
  try {
    const clip = JSON.parse(text) as RawClip;
    const objects = Array.isArray(clip.objects) ? clip.objects.filter((each) => Array.isArray(each?.components)) : [];
    return { ...clip, objects };
  } catch (cause) {
    throw new FileError([{ path: '', problem: t('The clipboard holds no objects: copy some first.') }], { cause });
  }
}

/**
 * The assets that come with copied objects, each after those that it uses. @throws FileError for text of another kind
 */
export const assetsOfClip = (text: string): readonly FileAsset[] =>
  checked({ ...readClip(text), objects: [] }, { registry: new ComponentRegistry() }).assets;

/** Whether a scene can use a copied asset at once: it has it already, or the asset is made of fields, not code. */
export function isAssetThere(scene: Scene, asset: FileAsset): boolean {
  const { name, type, values } = asset;
  if (values === undefined) return nameInScene(scene, asset) !== null;
  return type !== 'script' || scene.assets.fieldAsset(name)?.get('source') === values.source;
}

const checked = (
  { assets = [], objects }: RawClip,
  options: ParseOptions,
  prefabs: readonly Prefab[] = [],
): FarolFile =>
  parseFile(
    { format: 'farol-scene', version: FILE_VERSION, name: 'Clipboard', activeCamera: null, assets, prefabs, objects },
    options,
  );

export interface PasteOptions {
  /** Label of the undo step, given the names of the copies; "Pasted …" when absent. */
  readonly label?: (names: string) => string;
  /** Moves the copies before they are added to the scene. */
  readonly place?: (copies: readonly GameObject[]) => void;
  /** Files and URLs read for the scene, by their names in the clipboard; optional for those that the scene has. */
  readonly read?: ReadonlyMap<string, ReadAsset>;
}

const NOTHING_READ: ReadonlyMap<string, ReadAsset> = new Map();

/**
 * Adds copied objects below a parent, with unchanged world poses and new ids and names, and selects them. Assets and
 * prefabs that the scene lacks are added in the same step. The whole text is checked first.
 * @param parent - objects that had this parent keep their authored values exactly
 * @throws FileError listing what is wrong with the text; nothing has changed then
 */
export function pasteObjects(
  scene: Scene,
  text: string,
  parent: Container,
  selected: readonly string[],
  { label: labelOf, place = () => {}, read = NOTHING_READ }: PasteOptions = {},
): Command {
  const clip = readClip(text);
  const { objects } = clip;
  const naming = readNaming(clip.naming);
  const outer = takeOuterReferences(objects, scene, naming);
  const prefabs = newPrefabs(scene, clip);
  const options = { registry: scene.registry, assets: scene.assets };
  const file = checked(clip, options, [...scene.prefabs.list, ...prefabs]);
  const brought = bringAssets(scene, file.assets, read);
  const added = (file.prefabs ?? [])
    .filter(({ id }) => scene.prefabs.get(id) === null)
    .map((prefab) => ({ ...prefab, objects: renamedObjects(scene, prefab.objects, brought, naming) }));
  const made = makeObjects(renamedObjects(scene, file.objects, brought, naming), scene.registry);
  const byId = new Map<string, GameObject>();
  for (const root of made) root.traverse((object) => byId.set(object.id, object));
  for (const [id, component, name, value] of outer) byId.get(id)?.components[component]?.set(name, value);
  const copies = cloneTogether(made);
  copies.forEach((copy, i) => {
    const world = clip.worlds?.[i];
    const before = scene.findById(made[i].id);
    const isHome = before && (before.parent ?? scene) === parent;
    if (!isHome && isMatrix(world)) placeInWorld(copy, world, parent);
  });
  for (const root of made) root.dispose();
  place(copies);
  const pasted = countLabel(t('Pasted'), copies);
  nameUniquely(scene, copies);
  const label = labelOf?.(namesOf(copies)) ?? pasted;
  const end = childrenOf(parent).length;
  const placements = copies.map((object, i) => ({ object, parent, index: end + i }));
  const selection = { done: copies.map(({ id }) => id), undone: selected };
  const add = new PlaceObjects(label, scene, 'add', placements, selection);
  const steps: (() => Command)[] = [() => add];
  for (const prefab of added.toReversed()) steps.unshift(() => new SetPrefab(scene, prefab.id, prefab));
  if (brought.taken.length > 0) steps.unshift(() => new AddAssets(scene.assets, brought.taken));
  return steps.length === 1 ? add : new Sequence(label, steps, selection);
}
