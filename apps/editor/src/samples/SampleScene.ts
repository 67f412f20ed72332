import { builtinComponents, ComponentRegistry, GameObject, type Scene } from '@farol/engine';
import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import {
  deserialize,
  FILE_VERSION,
  type FarolFile,
  type FileAsset,
  type FileComponent,
  type FileObject,
} from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';

/** Reads a file below `public`. */
export type ReadPublic = (path: string) => Promise<Uint8Array<ArrayBuffer>>;

export type Values = Readonly<Record<string, FieldValue>>;
/** A component: type, and fields that differ from the default. */
export type Part = readonly [type: string, values?: Values];

export interface Place {
  /** Position (m). */
  readonly position?: Vector3Tuple;
  /** Euler angles (rad). */
  readonly rotation?: Vector3Tuple;
  readonly scale?: Vector3Tuple;
  /** Point that the object's front faces, in its parent's space (m); replaces `rotation`. */
  readonly target?: Vector3Tuple;
  readonly tags?: readonly string[];
  /** Whether the object is static, for baked light. */
  readonly static?: boolean;
  /** Id of the parent; the top of the tree when absent. */
  readonly parent?: string;
}

/** Overridden fields of an instance, by path: 'Lamp/Light.intensity'. */
export type Overrides = Readonly<Record<string, FieldValue>>;

const placer = new GameObject();

function transformOf({ position, rotation, scale, target }: Place): Record<string, FieldValue> {
  if (target) placer.transform.lookAt(position ?? [0, 0, 0], target);
  const turned = target ? placer.transform.rotation : rotation;
  return { ...(position && { position }), ...(turned && { rotation: turned }), ...(scale && { scale }) };
}

/** Builds the file of a sample. Ids depend only on names and order, so that the file is reproducible. */
export class SampleScene {
  readonly settings: Record<string, FieldValue> = {};
  readonly microShaders: Record<string, string> = {};
  activeCamera: string | null = null;
  private readonly assets: FileAsset[] = [];
  private readonly files = new Map<string, Blob>();
  private readonly prefabs: Prefab[] = [];
  private readonly counts = new Map<string, number>();
  private objects: FileObject[] = [];

  constructor(readonly name: string) {}

  /** Adds an object. @returns its id */
  object(name: string, place: Place, ...parts: readonly Part[]): string {
    const id = this.idOf(name);
    const components = [['Transform', transformOf(place)] as Part, ...parts].map(([type, values = {}], n) =>
      component(`${id}-${n}`, type, values),
    );
    const tags = place.tags ? { tags: [...place.tags] } : {};
    const still = place.static ? { static: true } : {};
    this.objects.push({ id, name, parent: place.parent ?? null, ...still, ...tags, components });
    return id;
  }

  /** Adds an asset made of fields. @returns its name */
  asset(type: 'material' | 'script' | 'clip' | 'surface', name: string, values: Record<string, FieldValue>): string {
    this.assets.push({ name, type, values });
    return name;
  }

  /** Adds an asset that is a file. @returns its name */
  file(type: FileAsset['type'], name: string, bytes: Uint8Array<ArrayBuffer>): string {
    const path = `assets/${encodeURIComponent(name)}`;
    this.assets.push({ name, type, file: path });
    this.files.set(path, new Blob([bytes]));
    return name;
  }

  /**
   * Adds a prefab.
   * @param build - adds one object with its children, and returns its id
   * @returns the prefab's id
   */
  prefab(name: string, build: () => string): string {
    const outerObjects = this.objects;
    this.objects = [];
    const root = build();
    const { objects } = this;
    this.objects = outerObjects;
    // the root's id is the prefab's
    this.prefabs.push({ id: root, name, objects });
    return root;
  }

  /** Adds an instance of a prefab. @returns the id of its root */
  instance(prefabId: string, place: Place, overrides: Overrides = {}, name?: string): string {
    const prefab = this.prefabs.find(({ id }) => id === prefabId);
    if (!prefab) throw new Error(`There is no prefab '${prefabId}'.`);
    const rootId = this.idOf(name ?? prefab.name);
    const ids = new Map(prefab.objects.map(({ id }) => [id, id === prefabId ? rootId : `${rootId}-${id}`]));
    const unusedPaths = new Set(Object.keys(overrides));
    for (const source of prefab.objects) {
      const id = ids.get(source.id)!;
      const isRoot = source.id === prefabId;
      const components = source.components.map(({ type, values }, i) => {
        const instanceValues: Record<string, FieldValue> = { ...values };
        const fields = builtinComponents.types.get(type)?.fields ?? {};
        for (const field of Object.keys(fields)) {
          if (fields[field].kind === 'object' && ids.has(instanceValues[field] as string))
            instanceValues[field] = ids.get(instanceValues[field] as string)!;
          const path = `${source.name}/${type}.${field}`;
          if (unusedPaths.delete(path)) instanceValues[field] = overrides[path];
        }
        if (isRoot && type === 'Transform') Object.assign(instanceValues, transformOf(place));
        return component(`${id}-${i}`, type, instanceValues);
      });
      this.objects.push({
        id,
        name: isRoot ? (name ?? source.name) : source.name,
        parent: isRoot ? (place.parent ?? null) : ids.get(source.parent!)!,
        prefab: { prefab: prefabId, source: source.id },
        components,
      });
    }
    if (unusedPaths.size > 0) throw new Error(`The prefab '${prefab.name}' has no ${[...unusedPaths].join(', ')}.`);
    return rootId;
  }

  /** Builds the scene, with the checks for every file. @throws FileError (as a rejection) naming the faults */
  async build(): Promise<Scene> {
    const file: FarolFile = {
      ...{ format: 'farol-scene', version: FILE_VERSION, name: this.name, settings: this.settings },
      ...{ activeCamera: this.activeCamera, assets: this.assets },
      ...(Object.keys(this.microShaders).length > 0 ? { microShaders: this.microShaders } : {}),
      ...(this.prefabs.length > 0 ? { prefabs: this.prefabs } : {}),
      objects: this.objects,
    };
    // components of scripts are kept as data
    const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
    return deserialize(JSON.stringify(file), { registry, fileOf: (path) => this.files.get(path) ?? null });
  }

  private idOf(name: string): string {
    const base = name.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-');
    const count = (this.counts.get(base) ?? 0) + 1;
    this.counts.set(base, count);
    return count === 1 ? base : `${base}-${count}`;
  }
}

const component = (id: string, type: string, values: Values): FileComponent => ({
  ...{ type, version: builtinComponents.types.get(type)?.version ?? 1, id, values: { ...values } },
});
