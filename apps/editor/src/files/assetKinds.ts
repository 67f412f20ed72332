import { t } from '@farol/editing';
import type { AssetLibrary, Scene } from '@farol/engine';
import type { AssetType } from '@farol/engine/fields';
import type { Prefab } from '@farol/engine/prefabs';
import type { Texture } from 'three';
import { canRename, splitName } from '../model/assetNames';

/** Kind of a card of the Assets panel: an asset type, or a prefab. */
export type AssetKind = AssetType | 'prefab';

/** Data of a card in the Assets panel. */
export interface AssetEntry {
  readonly kind: AssetKind;
  /** Name of the asset, or id of the prefab. */
  readonly name: string;
  readonly label: string;
  /** Whether the asset is built in, so that it cannot be deleted. */
  readonly isBuiltin: boolean;
  /** Path of the asset's folder; '' for the top. */
  readonly folder: string;
  /**
   * Whether the asset duplicates another one: a built-in texture in another size, or an image used twice in a model.
   */
  readonly isVariant: boolean;
  /** Model that the asset is a part of; null for none. */
  readonly model: string | null;
}

/** Whether a texture is an environment map. */
export const isEnvironment = (name: string): boolean => /\.(hdr|exr)$/i.test(name);

/** Display name of a kind of asset. @param isMany - plural */
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

/** Name of a built-in asset in words: 'Marble, normal map, 512' for 'marble-normal@512'. */
export function builtinName(name: string): string {
  const [, stem, isNormals, size] = /^(.+?)(-normal)?(?:@(\d+))?$/.exec(splitName(name).leaf)!;
  const words = t(englishWords(stem));
  const kind = isNormals === undefined ? words : t('{name}, normal map', { name: words });
  return size === undefined ? kind : `${kind}, ${size}`;
}

/** Words of the name of a built-in asset or of a part of one, in English. */
export const englishWords = (stem: string): string =>
  stem.charAt(0).toUpperCase() + stem.slice(1).replaceAll(/[-_]/g, ' ');

/** Own name of a part of a model: 'Walk' for 'clip-2-Walk', 'Mesh 2' for 'mesh-2', which has none. */
function partName(kind: AssetKind, leaf: string): string {
  const [, number, own] = /^[a-z]+-(\d+)-?(.*)$/.exec(leaf) ?? [];
  return number === undefined ? leaf : own || `${kindLabel(kind)} ${number}`;
}

const shared = { folder: '', isVariant: false, isBuiltin: false, model: null };

function prefabEntry({ id, name }: Prefab): AssetEntry {
  const { folder, leaf } = splitName(name);
  return { ...shared, kind: 'prefab', name: id, folder, label: leaf };
}

/**
 * A card of the Assets panel; null when nothing has this name. @param name - name of an asset, or id of a prefab, which
 * has precedence
 */
export function assetEntry(scene: Scene, name: string): AssetEntry | null {
  const prefab = scene.prefabs.get(name);
  return prefab ? prefabEntry(prefab) : libraryEntry(scene.assets, name);
}

function libraryEntry(assets: AssetLibrary, name: string): AssetEntry | null {
  const kind = assets.typeOf(name);
  if (!kind) return null;
  const { folder, leaf } = canRename(assets, name) ? splitName(name) : { folder: '', leaf: name };
  const model = assets.modelOf(name);
  const isBuiltin = assets.isBuiltin(name);
  return {
    ...shared,
    kind,
    name,
    model,
    folder: model !== null ? splitName(model).folder : folder,
    label: model !== null ? partName(kind, splitName(name).leaf) : isBuiltin ? builtinName(name) : leaf,
    isBuiltin,
    isVariant: isOtherSize(assets, name),
  };
}

/** All assets and prefabs of a scene: its own first, then parts of models. */
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

/** Whether a built-in texture is another built-in one in another size, as 'stone@512' is of 'stone'. */
const isOtherSize = (assets: AssetLibrary, name: string): boolean =>
  assets.isBuiltin(name) && assets.has(name.replace(/@\d+$/, '')) && /@\d+$/.test(name);

/** Image that several textures of a model may share; null for textures that are no part of a model. */
function pictureOf(assets: AssetLibrary, { kind, name }: AssetEntry): unknown {
  if (kind !== 'texture' || assets.modelOf(name) === null || !assets.isReady('texture', name)) return null;
  return (assets.texture(name) as Texture<unknown>).image;
}

/** Whether a texture is a normal map, judging by its name or by its use in its model. */
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
