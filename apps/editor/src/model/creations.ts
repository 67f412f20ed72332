import { t } from '@farol/editing';
import {
  AudioSource,
  Camera,
  type ComponentClass,
  Decal,
  GameObject,
  Light,
  lightShadows,
  meshShadows,
  ObjectRenderer,
  ParticleEmitter,
  particlePreset,
  Room,
  type Scene,
  Wall,
} from '@farol/engine';
import type { FieldValue, Vector3Tuple } from '@farol/engine/fields';

type Values = Readonly<Record<string, FieldValue>>;

/** An entry of the Add menu. */
export interface Creation {
  readonly label: string;
  readonly group: 'object' | 'building' | 'mesh' | 'light' | 'camera' | 'sound' | 'particles';
  /** Scene that a mesh belongs to; null for others. */
  readonly folder: string | null;
  /** Icon: 'mesh', 'wall', 'room', 'camera', 'decal', 'sound', 'particles', or the type of a light. */
  readonly kind: string;
  make(): GameObject | Promise<GameObject>;
}

/** Scales of meshes that would be too small at 1 m. */
const scales: Readonly<Record<string, Vector3Tuple>> = { plane: [10, 1, 10] };

/** Initial values of new lights, so that they are noticeable among others. */
const lightValues: Readonly<Record<string, Values>> = {
  ambient: { intensity: 0.3 },
  hemisphere: { intensity: 0.6 },
  directional: { intensity: 1.5, ...lightShadows.directional },
  point: { intensity: 12, range: 10, ...lightShadows.point },
  spot: { intensity: 30, range: 15, ...lightShadows.spot },
  rectangle: { intensity: 12, width: 1, height: 1 },
  disc: { intensity: 12, width: 1, height: 1 },
  tube: { intensity: 60, width: 1.2, height: 0.04 },
};

const capital = (word: string): string => word.charAt(0).toUpperCase() + word.slice(1);

function withComponent(name: string, type: ComponentClass, values: Values = {}): GameObject {
  const object = new GameObject(name);
  object.addComponent(type, values);
  return object;
}

const lightLabel = (type: string): string => t(`${capital(type)} light`);

function makeLight(type: string): GameObject {
  const object = withComponent(lightLabel(type), Light, { type, ...lightValues[type] });
  // lights shine along -Z: turned to point down; a sun slants
  if (type === 'spot' || type === 'rectangle' || type === 'disc') object.transform.rotation = [-Math.PI / 2, 0, 0];
  if (type === 'directional') object.transform.rotation = [-0.9, 0.6, 0];
  return object;
}

function makeDecal(): GameObject {
  const object = withComponent(t('Decal'), Decal);
  object.transform.rotation = [-Math.PI / 2, 0, 0]; // decals project along -Z: turned to point down
  return object;
}

/** Kinds of particles; the code of the renderer's presets is fetched when one is added. */
const particleCreations = (): Creation[] => {
  const creation = (label: string, make: Creation['make']): Creation => ({
    ...{ label, group: 'particles', folder: t('Particles'), kind: 'particles', make },
  });
  const preset = (label: string, name: Parameters<typeof particlePreset>[0]): Creation =>
    creation(label, async () => withComponent(label, ParticleEmitter, await particlePreset(name)));
  return [
    creation(t('Emitter'), () => withComponent(t('Particles'), ParticleEmitter)),
    preset(t('Fire'), 'fire'),
    preset(t('Smoke'), 'smoke'),
    preset(t('Sparks'), 'sparks'),
    preset(t('Fireflies'), 'fireflies'),
  ];
};

/** An object with a wall or a room, whose size is in fields. */
function makeBuilding(name: string, type: ComponentClass): GameObject {
  const object = withComponent(name, type);
  object.addComponent(ObjectRenderer, { mesh: null, ...meshShadows });
  return object;
}

const words = (name: string): string => capital(name.replaceAll(/[-_]/g, ' '));

/** Entry for a mesh of the library; a demo scene's mesh, such as 'temple/column', goes into a folder. */
function meshCreation(mesh: string): Creation {
  const [label, folder = null] = mesh
    .split('/')
    .map((name) => t(words(name)))
    .toReversed();
  const make = (): GameObject => {
    const object = withComponent(label, ObjectRenderer, { mesh, ...meshShadows });
    if (mesh in scales) object.transform.scale = scales[mesh];
    return object;
  };
  return { label, group: 'mesh', folder, kind: 'mesh', make };
}

/** All entries, from the registries: registered meshes and types of lights are included. */
export function creations(scene: Scene): Creation[] {
  const lights = Light.fields.type.options.map((type): Creation => ({
    label: lightLabel(type),
    group: 'light',
    folder: null,
    kind: type,
    make: () => makeLight(type),
  }));
  return [
    {
      label: t('Empty object'),
      group: 'object',
      folder: null,
      kind: 'object',
      make: () => new GameObject(t('Object')),
    },
    { label: t('Decal'), group: 'object', folder: null, kind: 'decal', make: makeDecal },
    {
      label: t('Room'),
      group: 'building',
      folder: null,
      kind: 'room',
      make: () => makeBuilding(t('Room'), Room),
    },
    {
      label: t('Wall'),
      group: 'building',
      folder: null,
      kind: 'wall',
      make: () => makeBuilding(t('Wall'), Wall),
    },
    ...particleCreations(),
    ...scene.assets.list('mesh').map(meshCreation),
    ...lights,
    {
      label: t('Camera'),
      group: 'camera',
      folder: null,
      kind: 'camera',
      make: () => withComponent(t('Camera'), Camera),
    },
    {
      label: t('Sound'),
      group: 'sound',
      folder: null,
      kind: 'sound',
      make: () => withComponent(t('Sound'), AudioSource),
    },
  ];
}
