import { fullKeys, type ValuesOf } from '@farol/editing/fields';
import type { ParticleSettings } from '@farol/renderer/particles';
import type { BufferGeometry, Mesh, Texture } from 'three';
import type { ColliderPose } from './ColliderPoses';
import type { particleFields } from './particleFields';

/** Values of the fields of a ParticleEmitter. */
export type ParticleValues = ValuesOf<typeof particleFields>;

/** Assets and objects that a ParticleEmitter's fields name; null for one that is missing or not loaded yet. */
export interface ParticleParts {
  /** Poses of the colliders that particles bounce off. */
  readonly colliders: readonly ColliderPose[];
  readonly surface: Mesh | null;
  readonly mesh: BufferGeometry | null;
  readonly texture: Texture | null;
}

/** Fields that name objects which particles bounce off. */
export const colliderObjects = ['collider1', 'collider2', 'collider3'] as const;
/** Radius (m) of a sphere that particles bounce off, if its object has scale 1: that of the editor's sphere. */
export const SPHERE_RADIUS = 0.5;

type Vector = readonly [number, number, number];
type FieldName = keyof typeof particleFields;

interface Rule<Name extends keyof ParticleSettings> {
  /** Names of the fields from which the setting is computed. */
  readonly fields: readonly FieldName[];
  make(values: ParticleValues, parts: ParticleParts): ParticleSettings[Name];
}

const same = <Name extends FieldName & keyof ParticleSettings>(name: Name): Rule<Name> => ({
  fields: [name],
  make: (values) => values[name] as unknown as ParticleSettings[Name],
});

/** Range from two numbers in any order. */
const between = (from: number, to: number): readonly [number, number] => (from <= to ? [from, to] : [to, from]);

/** For each setting: the fields that it depends on, and how its value is computed from them. */
const rules: { readonly [Name in keyof ParticleSettings]: Rule<Name> } = {
  capacity: same('capacity'),
  seed: same('seed'),
  rate: same('rate'),
  bursts: {
    fields: ['burstCount', 'burstTime', 'burstRepeats', 'burstInterval'],
    make: ({ burstCount: count, burstTime, burstRepeats, burstInterval }) =>
      count > 0 ? Array.from({ length: burstRepeats }, (_, i) => ({ time: burstTime + i * burstInterval, count })) : [],
  },
  delay: same('delay'),
  duration: same('duration'),
  loop: same('loop'),
  prewarm: same('prewarm'),
  shape: {
    fields: ['shape', 'radius', 'thickness', 'angle', 'boxSize', 'surface'],
    make({ shape, radius, thickness, angle, boxSize }, { surface }) {
      switch (shape) {
        case 'point':
          return { kind: shape };
        case 'sphere':
          return { kind: shape, radius, thickness };
        case 'cone':
          return { kind: shape, radius, angle };
        case 'box':
          return { kind: shape, size: boxSize };
        case 'mesh':
          return { kind: shape, mesh: surface };
      }
    },
  },
  life: { fields: ['lifeFrom', 'lifeTo'], make: ({ lifeFrom, lifeTo }) => between(lifeFrom, lifeTo) },
  speed: { fields: ['speedFrom', 'speedTo'], make: ({ speedFrom, speedTo }) => between(speedFrom, speedTo) },
  space: same('space'),
  inheritVelocity: same('inheritVelocity'),
  gravity: same('gravity'),
  drag: same('drag'),
  noiseStrength: same('noiseStrength'),
  noiseFrequency: same('noiseFrequency'),
  noiseScroll: same('noiseScroll'),
  colliders: {
    fields: [
      ...(['collides', 'planeNormal', 'planeHeight', 'bounce', 'friction', 'colliderKind'] as const),
      ...colliderObjects,
    ],
    make({ collides, planeNormal, planeHeight, bounce, friction, colliderKind }, { colliders }) {
      if (!collides) return [];
      const isDirection = Math.hypot(...planeNormal) > 0;
      const surface = { bounce, friction };
      const plane = (normal: Vector, height: number) => ({ kind: 'plane', normal, height, ...surface }) as const;
      return [
        plane(isDirection ? planeNormal : [0, 1, 0], planeHeight),
        ...colliders.map(({ position: p, up, scale }) =>
          colliderKind === 'sphere'
            ? ({ kind: 'sphere', center: p, radius: SPHERE_RADIUS * scale, ...surface } as const)
            : plane(up, up[0] * p[0] + up[1] * p[1] + up[2] * p[2]),
        ),
      ];
    },
  },
  size: { fields: ['sizeFrom', 'sizeTo'], make: ({ sizeFrom, sizeTo }) => between(sizeFrom, sizeTo) },
  sizeOverLife: same('sizeOverLife'),
  colorOverLife: { fields: ['colourOverLife'], make: ({ colourOverLife }) => fullKeys(colourOverLife) },
  brightness: same('brightness'),
  initialRotation: {
    fields: ['rotationFrom', 'rotationTo'],
    make: ({ rotationFrom, rotationTo }) => between(rotationFrom, rotationTo),
  },
  spin: { fields: ['spinFrom', 'spinTo'], make: ({ spinFrom, spinTo }) => between(spinFrom, spinTo) },
  spinOverLife: same('spinOverLife'),
  texture: { fields: ['texture'], make: (_values, { texture }) => texture },
  flipBook: {
    fields: ['flipBook', 'columns', 'rows', 'cycles'],
    make: ({ flipBook, columns, rows, cycles }) => (flipBook ? { columns, rows, cycles } : null),
  },
  render: same('render'),
  stretch: same('stretch'),
  orientation: same('orientation'),
  particleGeometry: { fields: ['mesh'], make: (_values, { mesh }) => mesh },
  blending: same('blending'),
  softness: same('softness'),
  lit: same('lit'),
  receiveShadow: same('receiveShadow'),
  lightEvery: {
    fields: ['shine', 'lightEvery'],
    make: ({ shine, lightEvery }) => (shine ? lightEvery : 0),
  },
  lightIntensity: same('lightIntensity'),
  lightRange: same('lightRange'),
};

const names = Object.keys(rules) as readonly (keyof ParticleSettings)[];

const settingOf = new Map<string, keyof ParticleSettings>();
for (const name of names) for (const field of rules[name].fields) settingOf.set(field, name);

/** Computes all settings from field values. */
export function particleSettings(values: ParticleValues, parts: ParticleParts): ParticleSettings {
  const settings: Record<string, unknown> = {};
  for (const name of names) settings[name] = rules[name].make(values, parts);
  return settings as unknown as ParticleSettings;
}

/** Current value of the setting that a field belongs to; empty for a field without one. */
export function changedSetting(field: string, values: ParticleValues, parts: ParticleParts): Partial<ParticleSettings> {
  const name = settingOf.get(field);
  return name === undefined ? {} : { [name]: rules[name].make(values, parts) };
}

/** Field values for given settings; textures, geometries and meshes have none. */
export function particleValues(settings: Partial<ParticleSettings>): Partial<ParticleValues> {
  const { bursts, shape, life, speed, size, initialRotation, spin, colliders, flipBook, colorOverLife, lightEvery } =
    settings;
  const given = names.filter(
    (name) => rules[name].fields[0] === name && settings[name] !== undefined && typeof settings[name] !== 'object',
  );
  const plane = colliders?.find(({ kind }) => kind === 'plane');
  return {
    ...Object.fromEntries(given.map((name) => [name, settings[name]])),
    ...(settings.gravity && { gravity: settings.gravity }),
    ...(settings.sizeOverLife && { sizeOverLife: settings.sizeOverLife }),
    ...(settings.spinOverLife && { spinOverLife: settings.spinOverLife }),
    ...(colorOverLife && { colourOverLife: colorOverLife }),
    ...(bursts && burstValues(bursts)),
    ...(shape && shapeValues(shape)),
    ...(life && { lifeFrom: life[0], lifeTo: life[1] }),
    ...(speed && { speedFrom: speed[0], speedTo: speed[1] }),
    ...(size && { sizeFrom: size[0], sizeTo: size[1] }),
    ...(initialRotation && { rotationFrom: initialRotation[0], rotationTo: initialRotation[1] }),
    ...(spin && { spinFrom: spin[0], spinTo: spin[1] }),
    ...(plane?.kind === 'plane' && {
      ...{ collides: true, planeNormal: plane.normal, planeHeight: plane.height },
      ...{ bounce: plane.bounce, friction: plane.friction },
    }),
    ...(flipBook && { flipBook: true, columns: flipBook.columns, rows: flipBook.rows, cycles: flipBook.cycles ?? 1 }),
    ...(lightEvery !== undefined && { shine: lightEvery > 0, lightEvery: Math.max(lightEvery, 1) }),
  };
}

/** Field values for equal bursts at equal intervals; for other bursts, of the first one alone. */
function burstValues(bursts: ParticleSettings['bursts']): Partial<ParticleValues> {
  const [first, second] = bursts;
  if (!first) return {};
  const interval = second ? second.time - first.time : 0;
  const isRow = bursts.every(
    ({ time, count }, i) => count === first.count && Math.abs(time - first.time - i * interval) < 1e-6,
  );
  const row = isRow && interval >= 0.01 ? { burstRepeats: bursts.length, burstInterval: interval } : {};
  return { burstCount: first.count, burstTime: first.time, ...row };
}

function shapeValues(shape: ParticleSettings['shape']): Partial<ParticleValues> {
  const { kind } = shape;
  switch (kind) {
    case 'sphere':
      return { shape: kind, radius: shape.radius, thickness: shape.thickness };
    case 'cone':
      return { shape: kind, radius: shape.radius, angle: shape.angle };
    case 'box':
      return { shape: kind, boxSize: shape.size };
    default:
      return { shape: kind };
  }
}
