import { t } from '@farol/editing';
import {
  type ComponentClass,
  GameObject,
  meshShadows,
  type NewObject,
  ObjectRenderer,
  type Scene,
} from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';

/** An entry of the Add menu. */
export interface Creation {
  readonly label: string;
  readonly group: 'mesh' | NonNullable<NewObject['group']>;
  /** Heading in the Add menu: the demo scene that a mesh comes from, or the kind of object; null for no heading. */
  readonly folder: string | null;
  /** Name of an icon; unknown names get a plain one. */
  readonly icon: string;
  make(): GameObject | Promise<GameObject>;
}

/** Scales of meshes that would be too small at 1 m. */
const scales: Readonly<Record<string, Vector3Tuple>> = { plane: [10, 1, 10] };

const emptyObject = (): Creation => ({
  ...{ label: t('Empty object'), group: 'object', folder: null, icon: 'object' },
  make: () => new GameObject(t('Object')),
});

/** Entry for one of a component's `newObjects`. */
function componentCreation(type: ComponentClass, entry: NewObject): Creation {
  const { label, name = label, group = 'object', icon = type.icon, rotation, values } = entry;
  return {
    label: t(label),
    group,
    folder: group === 'particles' ? t('Particles') : null,
    icon,
    async make() {
      const object = new GameObject(t(name));
      object.addComponent(type, typeof values === 'function' ? await values() : values);
      if (entry.with) object.addComponent(...entry.with);
      if (rotation) object.transform.rotation = rotation;
      return object;
    },
  };
}

const words = (name: string): string => name.charAt(0).toUpperCase() + name.slice(1).replaceAll(/[-_]/g, ' ');

/** Entry for a mesh of the library; a demo scene's mesh, such as 'temple/column', goes into a folder. */
function meshCreation(mesh: string): Creation {
  const [label, folder = null] = mesh
    .split('/')
    .map((name) => t(words(name)))
    .toReversed();
  const make = (): GameObject => {
    const object = new GameObject(label);
    object.addComponent(ObjectRenderer, { mesh, ...meshShadows });
    if (mesh in scales) object.transform.scale = scales[mesh];
    return object;
  };
  return { label, group: 'mesh', folder, icon: 'mesh', make };
}

/** All entries: an empty object, objects with components, and the meshes of the library. */
export const creations = ({ registry, assets }: Scene): Creation[] => [
  emptyObject(),
  ...[...registry.types.values()].flatMap((type) =>
    Object.hasOwn(type, 'newObjects') ? type.newObjects.map((entry) => componentCreation(type, entry)) : [],
  ),
  ...assets.list('mesh').map(meshCreation),
];
