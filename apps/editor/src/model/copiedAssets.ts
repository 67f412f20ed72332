import type { FieldAsset, GameObject, Scene } from '@farol/engine';
import type { FieldTable, FieldValue } from '@farol/engine/fields';
import {
  assetFields,
  assetInFile,
  createId,
  type FileAsset,
  type FileObject,
  UnknownComponent,
} from '@farol/engine/files';
import { importsOf } from './scriptImports';
import { scriptOfType } from './scriptNames';

/** Fields of a component type that refer to assets and objects, for a scene without that type. */
export interface NamingFields {
  readonly assets: readonly string[];
  readonly objects: readonly string[];
}

export interface CopiedAssets {
  /** Assets, each after those that it uses. File assets refer to entries of `files`. */
  readonly assets: readonly FileAsset[];
  readonly files: ReadonlyMap<string, Blob>;
  /** Fields that refer to assets and objects, for each component type defined by a script. */
  readonly naming: Readonly<Record<string, NamingFields>>;
}

/** Name of each file in the clipboard; repeated copies of a file share a name. */
const fileNames = new WeakMap<Blob, string>();

export function fileNameOf(blob: Blob): string {
  const name = fileNames.get(blob) ?? createId();
  fileNames.set(blob, name);
  return name;
}

/** The assets that objects use, directly or through other assets, except built-in ones. */
export function copiedAssets(scene: Scene, objects: readonly GameObject[], data: readonly FileObject[]): CopiedAssets {
  const list = new CopyList(scene);
  for (const { components } of data) {
    for (const { type, values } of components) {
      list.addUsed(values, scene.registry.types.get(type)?.fields ?? {});
      list.addScriptOf(type);
    }
  }
  for (const object of objects) {
    object.traverse(({ components }) => {
      for (const each of components) if (each instanceof UnknownComponent) list.addKept(each);
    });
  }
  return list;
}

class CopyList implements CopiedAssets {
  readonly assets: FileAsset[] = [];
  readonly files = new Map<string, Blob>();
  readonly naming: Record<string, NamingFields> = {};
  private readonly seen = new Set<string>();
  private readonly seenTypes = new Set<string>();

  constructor(private readonly scene: Scene) {}

  addUsed(values: Readonly<Record<string, FieldValue>>, fields: FieldTable): void {
    for (const { name, default: usual } of assetFields(fields)) {
      const value = Object.hasOwn(values, name) ? values[name] : usual;
      if (typeof value === 'string') this.add(value);
    }
  }

  /** Adds the script that defines a component type. */
  addScriptOf(type: string): void {
    if (this.seenTypes.has(type)) return;
    this.seenTypes.add(type);
    const script = scriptOfType(this.scene, type);
    if (script === null) return;
    this.add(script);
    const known = this.scene.registry.types.get(type);
    if (!known) return;
    const named = Object.entries(known.fields);
    this.naming[type] = {
      assets: assetFields(known.fields).map(({ name }) => name),
      objects: named.flatMap(([name, { kind }]) => (kind === 'object' ? [name] : [])),
    };
  }

  /**
   * Adds the assets and objects that an unknown component may use: each text that equals the name of an asset or the id
   * of an object.
   */
  addKept(component: UnknownComponent): void {
    const { assets, objects } = this.naming[component.typeName] ?? { assets: [], objects: [] };
    const named = { assets: new Set(assets), objects: new Set(objects) };
    for (const [name, value] of Object.entries(component.authoredValues())) {
      if (typeof value !== 'string') continue;
      if (this.scene.findById(value)) named.objects.add(name);
      if (!this.scene.assets.has(value)) continue;
      named.assets.add(name);
      this.add(value);
    }
    this.naming[component.typeName] = { assets: [...named.assets], objects: [...named.objects] };
  }

  private add(used: string): void {
    const { assets } = this.scene;
    const name = assets.modelOf(used) ?? used;
    const type = assets.typeOf(name);
    if (type === null || this.seen.has(name)) return;
    this.seen.add(name);
    const made = assets.fieldAsset(name);
    const blob = assets.fileOf(name);
    const url = assets.urlOf(name);
    if (made) {
      this.addUsed(made.changedValues(), made.fields);
      if (type === 'script') this.addImports(made);
      this.assets.push(assetInFile(made));
    } else if (blob) {
      const file = fileNameOf(blob);
      this.files.set(file, blob);
      this.assets.push({ name, type, file });
    } else if (url && !url.startsWith('blob:')) this.assets.push({ name, type, url });
  }

  private addImports(script: FieldAsset): void {
    const { assets } = this.scene;
    const isScript = (name: string): boolean => assets.fieldAsset(name)?.type === 'script';
    for (const name of importsOf(script.get('source') as string, script.name, isScript)) this.add(name);
  }
}
