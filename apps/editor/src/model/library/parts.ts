import { t } from '@farol/editing';
import { meshShadows } from '@farol/engine';
import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';
import type { FileAsset, FileObject } from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';
import { type LibraryMaterial, libraryMaterials } from './materials';

type Values = Readonly<Record<string, FieldValue>>;

/** Pose of a part below its parent. */
export interface Place {
  /** Position (m). */
  readonly at?: Vector3Tuple;
  /** Euler angles XYZ (rad). */
  readonly turn?: Vector3Tuple;
  /** Scale; of a mesh its size (m). */
  readonly size?: Vector3Tuple;
}

/** An object of a library's item, with what is below it. */
export interface Part extends Place {
  /** English name. */
  readonly name: string;
  readonly tags?: readonly string[];
  /** Types of components with the values that are no defaults. */
  readonly components?: readonly (readonly [type: string, values: Values])[];
  readonly parts?: readonly Part[];
}

/** An item's uppermost part, which has the item's name. */
export type ItemRoot = Omit<Part, 'name'>;

/** Rotation (rad) that turns the front, -Z, downwards. */
export const DOWN: Vector3Tuple = [-Math.PI / 2, 0, 0];

/** A mesh with a material of the library; it throws shadows unless `values` say otherwise. */
export const mesh = (name: string, shape: string, material: LibraryMaterial, place: Place, values?: Values): Part => ({
  name,
  ...place,
  components: [['ObjectRenderer', { mesh: shape, ...meshShadows, material, ...values }]],
});

/** A mesh that shines, and throws no shadow of the light within it. */
export const glow = (name: string, shape: string, material: LibraryMaterial, place: Place): Part =>
  mesh(name, shape, material, place, { castShadow: false, receiveShadow: false });

export const light = (values: Values, place: Place = {}, name = 'Light'): Part => ({
  name,
  ...place,
  components: [['Light', values]],
});

/** Prefab of an item, and the materials that it uses. */
export interface BuiltItem {
  readonly prefab: Prefab;
  readonly assets: readonly FileAsset[];
}

/** Name that a material of the library has in scenes, in the language that is shown. */
export const materialName = (material: LibraryMaterial): string => `${t('Library')}/${t(material)}`;

export const materialAsset = (material: LibraryMaterial): FileAsset => ({
  name: materialName(material),
  type: 'material',
  values: { ...libraryMaterials[material] },
});

/** Prefab of an item, in the language that is shown. @param id - of the item, such as 'street-lamp' @param name - English */
export function buildItem(id: string, name: string, root: ItemRoot): BuiltItem {
  const objects: FileObject[] = [];
  const used = new Map<string, FileAsset>();
  const add = ({ name, at, turn, size, tags, components = [], parts = [] }: Part, parent: string | null): void => {
    const own = parent === null ? `library-${id}` : `library-${id}-${objects.length}`;
    const pose = { ...(at && { position: at }), ...(turn && { rotation: turn }), ...(size && { scale: size }) };
    const made = [['Transform', pose as Values] as const, ...components].map(([type, values]) => {
      const material = values.material as LibraryMaterial | undefined;
      if (material) used.set(material, materialAsset(material));
      const named = material ? { ...values, material: materialName(material) } : { ...values };
      return { type, version: 1, id: `${own}:${type}`, values: named as Record<string, FieldValue> };
    });
    objects.push({ id: own, name: t(name), parent, ...(tags && { tags: [...tags] }), components: made });
    for (const each of parts) add(each, own);
  };
  add({ ...root, name }, null);
  return { prefab: { id: objects[0].id, name: objects[0].name, objects }, assets: [...used.values()] };
}
