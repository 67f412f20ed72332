import type { FieldAssetType, Scene, TakenAsset } from '@farol/engine';
import { type FieldValue, sameValue } from '@farol/engine/fields';
import { assetFields, fieldAssetFields, type FileAsset, type FileObject } from '@farol/engine/files';
import { freeNameAmong, numberedNames } from './assetNames';
import { fileNameOf, type NamingFields } from './copiedAssets';
import { sourceWithImports } from './scriptImports';
import { componentTypeOf, scriptOfType, sourceForName, sourceForType } from './scriptNames';

/**
 * The result of reading a copied file or URL for a scene: the asset, ready to be added under its name; the name of an
 * equal asset of the scene; or null when it could not be read.
 */
export type ReadAsset = TakenAsset | string | null;

/** Assets that are added to a scene with pasted objects. */
export interface BroughtAssets {
  /** Assets to add, which the scene does not have yet. */
  readonly taken: readonly TakenAsset[];
  /**
   * Name in the scene of each asset, by its name in the clipboard: an equal asset of the scene is shared; a different
   * one with that name is not replaced.
   */
  readonly names: ReadonlyMap<string, string>;
  /** Renamed component types of scripts, by their old names. */
  readonly types: ReadonlyMap<string, string>;
  /** Names of assets that could not be read; references to them are removed. */
  readonly missing: ReadonlySet<string>;
}

/**
 * Prepares the assets of copied objects for a scene.
 * @param list - the copied assets, each after those that it uses
 * @param read - files and URLs that were read, by their names in the clipboard
 */
export function bringAssets(
  scene: Scene,
  list: readonly FileAsset[],
  read: ReadonlyMap<string, ReadAsset>,
): BroughtAssets {
  const bringing = new Bringing(scene, list);
  for (const asset of list) bringing.bring(asset, read.get(asset.name));
  return bringing;
}

/** Name under which a scene already has a copied file or URL; null when it does not have it. */
export function nameInScene({ assets }: Scene, { name, type, file, url }: FileAsset): string | null {
  if (url !== undefined) return assets.urlOf(name) === url ? name : null;
  if (file === undefined) return null;
  return assets.files.find((each) => each.type === type && fileNameOf(each.blob) === file)?.name ?? null;
}

const sameValues = (a: Readonly<Record<string, FieldValue>>, b: Readonly<Record<string, FieldValue>>): boolean =>
  Object.keys(a).length === Object.keys(b).length &&
  Object.keys(a).every((name) => name in b && sameValue(a[name], b[name]));

class Bringing implements BroughtAssets {
  readonly taken: TakenAsset[] = [];
  readonly names = new Map<string, string>();
  readonly types = new Map<string, string>();
  readonly missing = new Set<string>();
  private readonly scripts: ReadonlySet<string>;
  /** Names in the scene already given to other copied assets; `takenTypes`: component types already given. */
  private readonly takenNames = new Set<string>();
  private readonly takenTypes = new Set<string>();

  constructor(
    private readonly scene: Scene,
    list: readonly FileAsset[],
  ) {
    this.scripts = new Set(list.filter(({ type }) => type === 'script').map(({ name }) => name));
  }

  bring(asset: FileAsset, read: ReadAsset | undefined): void {
    const { name, type, values } = asset;
    const known = read === undefined ? nameInScene(this.scene, asset) : read;
    if (typeof known === 'string') this.names.set(name, known);
    else if (known) {
      this.names.set(name, known.name);
      this.put(known);
    } else if (values && type === 'script') this.bringScript(name, values);
    else if (values) this.bringFields(type as FieldAssetType, name, values);
    else if (asset.url !== undefined && read === undefined) this.bringUrl(asset, asset.url);
    else this.missing.add(name);
  }

  private bringUrl({ name, type }: FileAsset, url: string): void {
    const { assets } = this.scene;
    const free = freeNameAmong((wanted) => this.isTaken(wanted) && assets.urlOf(wanted) !== url, name);
    this.names.set(name, free);
    if (assets.has(free)) return;
    assets.registerUrl(free, url, type);
    this.put(assets.take(free));
  }

  private bringFields(type: FieldAssetType, name: string, before: Readonly<Record<string, FieldValue>>): void {
    const { assets } = this.scene;
    const named = assetFields(fieldAssetFields[type]).map((each) => each.name);
    const values = renamedValues(before, named, this);
    const isOther = (wanted: string): boolean => {
      const known = assets.fieldAsset(wanted);
      return this.isTaken(wanted) && !(known?.type === type && sameValues(known.changedValues(), values));
    };
    const free = freeNameAmong(isOther, name);
    this.names.set(name, free);
    if (assets.has(free)) return;
    assets.addFieldAsset(type, free, values);
    this.put(assets.take(free));
  }

  private bringScript(name: string, values: Readonly<Record<string, FieldValue>>): void {
    const { assets } = this.scene;
    const source = sourceWithImports(typeof values.source === 'string' ? values.source : '', name, this.names, (each) =>
      this.scripts.has(each),
    );
    const before = componentTypeOf(name, source);
    let number = 1;
    for (const free of numberedNames(name)) {
      const text = number === 1 ? source : sourceForType(sourceForName(source, name, free), number);
      number++;
      const type = componentTypeOf(free, text);
      const known = assets.fieldAsset(free);
      const isSame = known?.type === 'script' && known.get('source') === text;
      if (!isSame && (this.isTaken(free) || (type !== null && this.isTypeTaken(type)))) continue;
      this.names.set(name, free);
      if (before !== null && type !== null) {
        this.takenTypes.add(type);
        if (type !== before) this.types.set(before, type);
      }
      if (isSame) return;
      assets.addFieldAsset('script', free, { ...values, source: text });
      this.put(assets.take(free));
      return;
    }
  }

  private put(taken: TakenAsset): void {
    this.taken.push(taken);
    this.takenNames.add(taken.name);
  }

  private isTaken(name: string): boolean {
    return this.takenNames.has(name) || this.scene.assets.has(name);
  }

  private isTypeTaken(type: string): boolean {
    const { scene } = this;
    return this.takenTypes.has(type) || scene.registry.types.has(type) || scriptOfType(scene, type) !== null;
  }
}

/** Name in the scene of a copied asset, or of a part of a model; null for one that could not be read. */
function assetNameIn(name: string, { names, missing }: Pick<BroughtAssets, 'names' | 'missing'>): string | null {
  for (let end = name.length; end > 0; end = name.lastIndexOf('/', end - 1)) {
    const whole = name.slice(0, end);
    if (missing.has(whole)) return null;
    const next = names.get(whole);
    if (next !== undefined) return next + name.slice(end);
  }
  return name;
}

/** Values with assets renamed to their names in the scene, and without assets that could not be read. */
function renamedValues(
  values: Readonly<Record<string, FieldValue>>,
  fields: readonly string[],
  brought: Pick<BroughtAssets, 'names' | 'missing'>,
): Record<string, FieldValue> {
  const renamed = { ...values };
  for (const field of fields) {
    const value = renamed[field];
    if (typeof value !== 'string') continue;
    const next = assetNameIn(value, brought);
    if (next === null) delete renamed[field];
    else renamed[field] = next;
  }
  return renamed;
}

/** Copied objects with assets and component types renamed to their names in the scene. */
export function renamedObjects(
  scene: Scene,
  objects: readonly FileObject[],
  brought: BroughtAssets,
  naming: Readonly<Record<string, NamingFields>>,
): FileObject[] {
  return objects.map((object) => ({
    ...object,
    components: object.components.map((component) => {
      const { type, values } = component;
      const known = scene.registry.types.get(type);
      const fields = naming[type]?.assets ?? (known ? assetFields(known.fields).map(({ name }) => name) : []);
      return { ...component, type: brought.types.get(type) ?? type, values: renamedValues(values, fields, brought) };
    }),
  }));
}
