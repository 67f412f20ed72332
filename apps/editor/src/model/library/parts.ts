import { t } from '@farol/editing';
import { meshShadows } from '@farol/engine';
import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import type { FileAsset, FileObject } from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';
import { type LibraryMaterial, libraryMaterials } from './materials';
import { libraryScripts } from './scripts';

type Values = Readonly<Record<string, FieldValue>>;

/** Pose of a part below its parent. */
export interface Place {
  /** Position (m). */
  readonly at?: Vector3Tuple;
  /** Euler angles XYZ (rad). */
  readonly turn?: Vector3Tuple;
  /** Scale; for a mesh its size (m). */
  readonly size?: Vector3Tuple;
}

/** Type of a component, and values that differ from defaults; 'part:Hinge' stands for the id of the part Hinge. */
export type PartComponent = readonly [type: string, values: Values];

/** An object of a library item, with its children. */
export interface Part extends Place {
  /** Name of the object, in English. */
  readonly name: string;
  readonly tags?: readonly string[];
  readonly components?: readonly PartComponent[];
  readonly parts?: readonly Part[];
}

/** Root object of an item, which gets the item's name. */
export type ItemRoot = Omit<Part, 'name'>;

/** Rotation (rad) that turns an object's front, its -Z axis, downwards. */
export const DOWN: Vector3Tuple = [-Math.PI / 2, 0, 0];

/** A mesh with a material of the library; it casts shadows unless `values` say otherwise. */
export const mesh = (name: string, shape: string, material: LibraryMaterial, place: Place, values?: Values): Part => ({
  name,
  ...place,
  components: [['ObjectRenderer', { mesh: shape, ...meshShadows, material, ...values }]],
});

/** An emissive mesh, which casts no shadow of the light inside it. */
export const glow = (name: string, shape: string, material: LibraryMaterial, place: Place): Part =>
  mesh(name, shape, material, place, { castShadow: false, receiveShadow: false });

/** A part that bodies collide with: a box round its mesh unless `shape` says otherwise. */
export const solid = (part: Part, shape?: 'cylinder'): Part => ({
  ...part,
  components: [...(part.components ?? []), ['Collider', shape ? { shape } : {}]],
});

export const light = (values: Values, place: Place = {}, name = 'Light'): Part => ({
  name,
  ...place,
  components: [['Light', values]],
});

/** Prefab of an item, and the materials and scripts that it uses. */
export interface BuiltItem {
  readonly prefab: Prefab;
  readonly assets: readonly FileAsset[];
}

/** Name that a material of the library has in scenes, in the user's language. */
export const materialName = (material: LibraryMaterial): string => `${t('Library')}/${t(material)}`;

export const materialAsset = (material: LibraryMaterial): FileAsset => ({
  name: materialName(material),
  type: 'material',
  values: { ...libraryMaterials[material] },
});

export const scriptAsset = (type: string): FileAsset => ({
  name: `${t('Library')}/${type}`,
  type: 'script',
  values: { source: libraryScripts[type] },
});

/** Values of a component with names and ids of the scene. @param idOf - id of a part, by its English name */
function namedValues(values: Values, idOf: ReadonlyMap<string, string>): Record<string, FieldValue> {
  const named: Record<string, FieldValue> = { ...values };
  if (typeof values.material === 'string') named.material = materialName(values.material as LibraryMaterial);
  for (const [field, value] of Object.entries(values))
    if (typeof value === 'string' && value.startsWith('part:')) named[field] = idOf.get(value.slice(5))!;
  return named;
}

/** Prefab of an item, in the user's language. @param id - its id, such as 'street-lamp' @param name - English name */
export function buildItem(id: string, name: string, root: ItemRoot): BuiltItem {
  const list: { readonly part: Part; readonly id: string; readonly parent: string | null }[] = [];
  const idOf = new Map<string, string>();
  const visit = (part: Part, parent: string | null): void => {
    const own = parent === null ? `library-${id}` : `library-${id}-${list.length}`;
    idOf.set(part.name, own);
    list.push({ part, id: own, parent });
    for (const each of part.parts ?? []) visit(each, own);
  };
  visit({ ...root, name }, null);
  const used = new Map<string, FileAsset>();
  const objects = list.map(({ part, id: own, parent }): FileObject => {
    const { at, turn, size, tags, components = [] } = part;
    const pose = { ...(at && { position: at }), ...(turn && { rotation: turn }), ...(size && { scale: size }) };
    const counts = new Map<string, number>();
    const made = [['Transform', pose as Values] as const, ...components].map(([type, values]) => {
      const count = (counts.get(type) ?? 0) + 1;
      counts.set(type, count);
      const material = values.material as LibraryMaterial | undefined;
      if (material) used.set(material, materialAsset(material));
      if (Object.hasOwn(libraryScripts, type)) used.set(type, scriptAsset(type));
      return { type, version: 1, id: `${own}:${type}${count > 1 ? count : ''}`, values: namedValues(values, idOf) };
    });
    return { id: own, name: t(part.name), parent, ...(tags && { tags: [...tags] }), components: made };
  });
  return { prefab: { id: objects[0].id, name: objects[0].name, objects }, assets: [...used.values()] };
}
