import { t } from '@farol/editing';
import type { AssetLibrary, Scene } from '@farol/engine';
import type { AssetType } from '@farol/engine/fields';
import type { Prefab } from '@farol/engine/prefabs';
import type { Texture } from 'three';
import { canRename, splitName } from '../model/assetNames';

/** What the Assets panel shows: assets of the library, and prefabs. */
export type AssetKind = AssetType | 'prefab';

/** One card of the Assets panel. */
export interface AssetEntry {
  readonly kind: AssetKind;
  /** Name of the asset, id of the prefab. */
  readonly name: string;
  readonly label: string;
  /** Whether it came with Farol, and cannot be deleted. */
  readonly isBuiltin: boolean;
  /** Path of the folder that it is in; '' for the top. */
  readonly folder: string;
  /** Whether it is another one over again: a built-in texture of another size, or one picture twice in a model. */
  readonly isVariant: boolean;
}

/** Whether a texture is one of light from all sides. */
export const isEnvironment = (name: string): boolean => /\.(hdr|exr)$/i.test(name);

/** What a kind of asset is called. @param isMany - of several */
export const kindLabel = (kind: AssetKind, isMany = false): string =>
  ({
    prefab: isMany ? t('Prefabs') : t('Prefab'),
    model: isMany ? t('Models') : t('Model'),
    mesh: isMany ? t('Meshes') : t('Mesh'),
    texture: isMany ? t('Textures') : t('Texture'),
    material: isMany ? t('Materials') : t('Material'),
    shader: isMany ? t('Shaders') : t('Shader'),
    script: isMany ? t('Scripts') : t('Script'),
    clip: isMany ? t('Clips') : t('Clip ## of an animation'),
    sound: isMany ? t('Sounds') : t('Sound'),
    profile: isMany ? t('Light profiles') : t('Light profile'),
    surface: isMany ? t('Surfaces') : t('Surface'),
    bake: t('Baked light'),
  })[kind];

const shared = { folder: '', isVariant: false, isBuiltin: false };

function prefabEntry({ id, name }: Prefab): AssetEntry {
  const { folder, leaf } = splitName(name);
  return { ...shared, kind: 'prefab', name: id, folder, label: leaf };
}

/** A card of the Assets panel; null where nothing is of that name. @param name - of an asset, or id of a prefab, which goes first */
export function assetEntry(scene: Scene, name: string): AssetEntry | null {
  const prefab = scene.prefabs.get(name);
  return prefab ? prefabEntry(prefab) : libraryEntry(scene.assets, name);
}

function libraryEntry(assets: AssetLibrary, name: string): AssetEntry | null {
  const kind = assets.typeOf(name);
  if (!kind) return null;
  const { folder, leaf } = canRename(assets, name) ? splitName(name) : { folder: '', leaf: name };
  const isPart = assets.modelOf(name) !== null;
  return {
    ...shared,
    kind,
    name,
    folder: isPart ? splitName(assets.modelOf(name)!).folder : folder,
    label: isPart ? splitName(name).leaf : leaf,
    isBuiltin: assets.isBuiltin(name),
    isVariant: isOtherSize(assets, name),
  };
}

/** Everything that can be used in a scene: its own first, parts of models after them. */
export function assetEntries(scene: Scene): AssetEntry[] {
  const { assets } = scene;
  const pictures = new Set<unknown>();
  const entries = assets.list().flatMap((name): AssetEntry[] => {
    const entry = libraryEntry(assets, name);
    if (!entry) return [];
    const picture = pictureOf(assets, entry);
    if (picture === null) return [entry];
    const isTwice = pictures.has(picture);
    pictures.add(picture);
    return [isTwice ? { ...entry, isVariant: true } : entry];
  });
  const rank = ({ name, isBuiltin }: AssetEntry): number => (isBuiltin ? 2 : assets.modelOf(name) ? 1 : 0);
  return [...scene.prefabs.list.map(prefabEntry), ...entries.toSorted((a, b) => rank(a) - rank(b))];
}

/** A built-in texture of another size than the usual one: 'stone@512'. */
const isOtherSize = (assets: AssetLibrary, name: string): boolean =>
  assets.isBuiltin(name) && assets.has(name.replace(/@\d+$/, '')) && /@\d+$/.test(name);

/** What the textures of a model share that show one picture; null for what is no part. */
function pictureOf(assets: AssetLibrary, { kind, name }: AssetEntry): unknown {
  if (kind !== 'texture' || assets.modelOf(name) === null || !assets.isReady('texture', name)) return null;
  return (assets.texture(name) as Texture<unknown>).image;
}

/** Whether a texture holds normals, as its name says, or the material of the model that it is a part of. */
export function holdsNormals(assets: AssetLibrary, name: string): boolean {
  if (/(^|[^a-z])(normals?|nrm|nor|norm|n)([^a-z]|$)/i.test(splitName(name).leaf.replace(/\.\w+$/, ''))) return true;
  const model = assets.modelOf(name);
  if (model === null || !assets.isReady('texture', name)) return false;
  const texture = assets.texture(name);
  return assets
    .partsOf(model)
    .some((part) => assets.typeOf(part) === 'material' && normalMapOf(assets, part) === texture);
}

const normalMapOf = (assets: AssetLibrary, material: string): unknown =>
  assets.isReady('material', material) ? (assets.material(material) as { normalMap?: Texture | null }).normalMap : null;
