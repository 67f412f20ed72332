import {
  Camera,
  type Component,
  type ComponentRegistry,
  type FieldAssetType,
  type GameObject,
  type Scene,
} from '@farol/engine';
import type { FieldOwner, FieldValue } from '@farol/engine/fields';
import { type FileComponent, type FileObject, makeObjects } from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';
import type { PartChange, PartKey } from '../../files/autosave/parts';
import { fileOfParts, headKey, type LiveAsset, SCRIPTS } from '../../files/live/liveParts';

type Values = Readonly<Record<string, FieldValue>>;

/** Sets an owner's fields to the values of a file; fields that are not listed get their defaults. */
function setValues(owner: FieldOwner, values: Values): void {
  const before = owner.changedValues();
  for (const name of Object.keys(before)) {
    if (!Object.hasOwn(values, name)) owner.set(name, owner.fields[name].default);
  }
  for (const name of Object.keys(values)) {
    if (JSON.stringify(before[name]) !== JSON.stringify(values[name])) owner.set(name, values[name]);
  }
}

function setComponents(
  gameObject: GameObject,
  components: readonly FileComponent[],
  registry: ComponentRegistry,
): void {
  const types = new Map(components.map(({ id, type }) => [id, type]));
  for (const component of [...gameObject.components]) {
    if (component === gameObject.transform || types.get(component.id) === component.typeName) continue;
    gameObject.removeComponent(component);
    component.dispose();
  }
  components.forEach((data, index) => {
    const { type, id, enabled = true, values } = data;
    const has = (each: Component): boolean => (type === 'Transform' ? each.typeName === type : each.id === id);
    const component = gameObject.components.find(has);
    if (!component) {
      gameObject.addComponent(registry.createFrom(data), {}, { id, enabled, index });
      return;
    }
    if (gameObject.components[index] !== component) gameObject.moveComponent(component, index);
    setValues(component, values);
    component.enabled = enabled;
  });
}

function setObject(gameObject: GameObject, data: FileObject, registry: ComponentRegistry): void {
  const { name, active = true, locked = false, static: isStatic = false, tags = [], prefab = null, components } = data;
  Object.assign(gameObject, { name, active, locked, isStatic });
  if (tags.join('\n') !== gameObject.tags.join('\n')) gameObject.tags = tags;
  if (JSON.stringify(prefab) !== JSON.stringify(gameObject.prefabLink)) gameObject.prefabLink = prefab;
  setComponents(gameObject, components, registry);
}

/** Updates the assets. @returns false when the scene must be created anew */
async function setAssets(
  scene: Scene,
  changes: ReadonlyMap<string, LiveAsset | null>,
  fileOf: FileOf,
): Promise<boolean> {
  const { assets } = scene;
  for (const [name, data] of changes) {
    const before = assets.fieldAsset(name);
    if (!data || (assets.has(name) && !before)) return false;
    if (before) {
      if (!data.values || data.type !== before.type) return false;
      setValues(before, data.values);
    } else if (data.values) assets.addFieldAsset(data.type as FieldAssetType, name, data.values);
    else if (data.file === undefined || data.hash === undefined) return false;
    else {
      assets.registerFile(name, await fileOf(data.hash), data.type);
      await assets.load(name);
    }
  }
  return true;
}

/** Fetches the bytes of an asset by their SHA-256. */
export type FileOf = (hash: string) => Promise<Blob>;

function setHead(scene: Scene, key: string, value: unknown): void {
  if (key === 'settings') setValues(scene.settings, value as Values);
  else if (key === 'name') scene.name = value as string;
  else if (key === 'microShaders') {
    const texts = (value ?? {}) as Record<string, string>;
    for (const name of scene.microShaders.texts.keys()) {
      if (!Object.hasOwn(texts, name)) scene.microShaders.set(name, null);
    }
    for (const name of Object.keys(texts)) scene.microShaders.set(name, texts[name]);
  } else if (key === 'activeCamera') {
    const camera = value === null ? null : scene.findById(value as string);
    scene.activeCamera = camera?.getComponent(Camera) ?? null;
  }
}

/** Replaces the prefabs, in the order of the file; their instances are updated by other parts of the scene. */
function setPrefabs(scene: Scene, prefabs: readonly Prefab[]): void {
  for (const { id } of [...scene.prefabs.list]) scene.prefabs.delete(id);
  for (const prefab of prefabs) scene.prefabs.set(prefab);
}

/**
 * Applies edits to a scene that plays. Parts equal to the scene's state change nothing; stored views and asset folders
 * are ignored, since no picture shows them.
 *
 * @param parts - all parts, with the changes
 * @returns false when the scene must be created anew: a loaded file was replaced, scripts were switched, or light was
 *   baked
 * @throws Error for parts that do not fit the scene, which must be created anew too
 */
export async function applyParts(
  scene: Scene,
  parts: ReadonlyMap<PartKey, string>,
  changes: readonly PartChange[],
  registry: ComponentRegistry,
  fileOf: FileOf,
): Promise<boolean> {
  const values = new Map(changes.map(([key, json]) => [key, json === null ? null : (JSON.parse(json) as unknown)]));
  const settings = values.get(headKey('settings')) as Values | undefined;
  // the code of baked light is fetched only while a scene file is read
  if (settings && (settings.bakedLight ?? null) !== scene.settings.getAuthored('bakedLight')) return false;
  if (values.has(SCRIPTS)) return false;
  const below = <T>(prefix: string): [string, T | null][] =>
    [...values].flatMap(([key, value]) =>
      key.startsWith(prefix) ? [[key.slice(prefix.length), value as T | null] as [string, T | null]] : [],
    );
  if (!(await setAssets(scene, new Map(below<LiveAsset>('a/')), fileOf))) return false;
  if ([...values.keys()].some((key) => /^[pqr](\/|$)/.test(key))) setPrefabs(scene, fileOfParts(parts).prefabs ?? []);
  const objects = below<FileObject>('o/');
  const added = objects.flatMap(([id, data]) => (data && !scene.findById(id) ? [{ ...data, parent: null }] : []));
  const news = new Map(makeObjects(added, registry).map((object) => [object.id, object]));
  for (const [id, children] of below<string[]>('c/')) {
    const container = id === '' ? scene : (news.get(id) ?? scene.findById(id));
    (children ?? []).forEach((child, index) => {
      const list = container === scene ? scene.roots : (container as GameObject).children;
      if (list[index]?.id === child) return;
      const object = news.get(child) ?? scene.findById(child);
      if (!object || !container) throw new Error(`The object ${child} is missing.`);
      container.add(object, index);
    });
  }
  for (const [id, data] of objects) {
    const object = scene.findById(id);
    if (data && object && !news.has(id)) setObject(object, data, registry);
    else if (!data) object?.dispose();
  }
  for (const [key, value] of below('h/')) setHead(scene, key, value);
  return true;
}
