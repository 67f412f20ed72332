import { type FieldValue, sameValue } from '@farol/editing/fields';
import type { AssetLibrary } from '../assets/AssetLibrary';
import type { FieldAsset } from '../assets/FieldAsset';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import type { SceneView } from '../core/SceneViews';
import { copyValue, type FieldOwner } from '../fields/FieldOwner';
import { savedFields } from '../fields/savedFields';
import { assetUses } from './assetUses';
import { type FarolFile, FILE_VERSION, type FileAsset, type FileObject, type FileView } from './FarolFile';

/** Options of `serialize`. */
export interface SerializeOptions {
  /** Library whose asset addresses are written; the scene's when absent. */
  assets?: AssetLibrary;
}

/** Authored values that differ from the defaults; a reference to a removed object becomes null. */
function changedValues(owner: FieldOwner, scene: Scene | null): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  for (const { name, field } of savedFields(owner.fields)) {
    let value = owner.getAuthored(name);
    if (field.kind === 'object' && typeof value === 'string' && scene && !scene.findById(value)) value = null;
    if (!sameValue(value, field.default)) values[name] = copyValue(value);
  }
  return values;
}

/** Sorts texts by name, so that equal texts make equal files. */
const sorted = (texts: ReadonlyMap<string, string>): Record<string, string> =>
  Object.fromEntries([...texts].toSorted(([a], [b]) => (a < b ? -1 : 1)));

/** Copies a camera bookmark, with members in a fixed order. */
const fileView = (place: number, { name, position, target, fov, orthographic }: SceneView): FileView => ({
  ...{ place, name, fov, orthographic },
  position: [position[0], position[1], position[2]],
  target: [target[0], target[1], target[2]],
});

/** Whether an object's prefab is in the scene; pasted objects may link to prefabs of other scenes. */
const hasPrefab = ({ prefabLink, scene }: GameObject): boolean =>
  prefabLink !== null && (!scene || scene.prefabs.get(prefabLink.prefab) !== null);

/** Serializes one GameObject without children. */
export function serializeObject(gameObject: GameObject): FileObject {
  return {
    id: gameObject.id,
    name: gameObject.name,
    parent: gameObject.parent?.id ?? null,
    ...(gameObject.active ? {} : { active: false }),
    ...(gameObject.locked ? { locked: true } : {}),
    ...(gameObject.isStatic ? { static: true } : {}),
    ...(gameObject.tags.length > 0 ? { tags: [...gameObject.tags] } : {}),
    ...(hasPrefab(gameObject) ? { prefab: gameObject.prefabLink! } : {}),
    components: gameObject.components.map((component) => ({
      type: component.typeName,
      version: component.componentClass.version,
      id: component.id,
      ...(component.enabled ? {} : { enabled: false }),
      values: changedValues(component, gameObject.scene),
    })),
  };
}

/** Serializes a field asset. */
export function assetInFile(asset: FieldAsset): FileAsset {
  return { name: asset.name, type: asset.type, values: asset.changedValues() };
}

/** Path of an asset in a container. Any name gives a safe path, also '..' or a lone surrogate. */
function pathInContainer(name: string): string {
  // a lone surrogate becomes '%u' and its code; after '%', encodeURIComponent writes hex digits only, so no paths clash
  const path = name
    .split(/([\ud800-\udfff])/u)
    .map((part, i) => (i % 2 === 1 ? `%u${part.charCodeAt(0).toString(16)}` : encodeURIComponent(part)))
    .join('');
  return `assets/${/^\.+$/.test(path) ? path.replaceAll('.', '%2E') : path}`;
}

/**
 * Assets of a library that a file can keep: those added as files, with their path in a container, those made of fields,
 * and those with a lasting address (not `blob:`).
 */
function lastingAssets(assets: AssetLibrary): FileAsset[] {
  // sorted by name, so that an asset that was removed and restored keeps its place in the file
  const files = assets.files.toSorted((a, b) => (a.name < b.name ? -1 : 1));
  const listed = files.map(({ name, type }): FileAsset => {
    return { name, type, file: pathInContainer(name) };
  });
  const ofFields = assets.fieldAssets().toSorted((a, b) => (a.name < b.name ? -1 : 1));
  for (const asset of ofFields) listed.push(assetInFile(asset));
  for (const name of assets.list()) {
    const url = assets.urlOf(name);
    const type = assets.typeOf(name);
    if (url && type && !url.startsWith('blob:')) listed.push({ name, type, url });
  }
  return listed;
}

const foldersIn = ({ folders }: AssetLibrary): Pick<FarolFile, 'assetFolders'> =>
  folders.length > 0 ? { assetFolders: folders } : {};

/** A scene without its objects, but with all assets that a file can keep: see `serialize`. */
export function serializeHead(scene: Scene, options: SerializeOptions = {}): FarolFile {
  return {
    format: 'farol-scene',
    version: FILE_VERSION,
    name: scene.name,
    settings: changedValues(scene.settings, null),
    activeCamera: scene.activeCamera?.gameObject.id ?? null,
    assets: lastingAssets(options.assets ?? scene.assets),
    ...foldersIn(options.assets ?? scene.assets),
    ...(scene.microShaders.texts.size > 0 ? { microShaders: sorted(scene.microShaders.texts) } : {}),
    ...(scene.views.entries.length > 0
      ? { views: scene.views.entries.map(([place, view]) => fileView(place, view)) }
      : {}),
    ...(scene.picture ? { picture: scene.picture } : {}),
    ...(scene.prefabs.list.length > 0 ? { prefabs: [...scene.prefabs.list] } : {}),
    objects: [],
  };
}

/** Texts in components of unknown types: each may name an asset. */
function unknownTexts(file: FarolFile, { registry }: Scene): string[] {
  return [file, ...(file.prefabs ?? [])]
    .flatMap(({ objects }) => objects.flatMap(({ components }) => components))
    .filter(({ type }) => !registry.types.has(type))
    .flatMap(({ values }) => Object.values(values).filter((value) => typeof value === 'string'));
}

/**
 * The scene as plain JSON data, with authored values, not simulated ones. Assets are written by name; the ones in use
 * are listed with their address, if it lasts, or with their path in a container if they were added as files: see
 * `writeContainer`.
 */
export function serialize(scene: Scene, options: SerializeOptions = {}): FarolFile {
  const file = serializeHead(scene, options);
  scene.traverse((gameObject) => file.objects.push(serializeObject(gameObject)));
  const used = new Set<string>();
  for (const name of [...assetUses(file, scene.registry).map((use) => use.name), ...unknownTexts(file, scene)]) {
    used.add(name);
    // a part of a model is loaded with its model
    used.add(scene.assets.modelOf(name) ?? name);
  }
  file.assets = file.assets.filter(
    ({ name, file: path, values }) => path !== undefined || values !== undefined || used.has(name),
  );
  return file;
}
