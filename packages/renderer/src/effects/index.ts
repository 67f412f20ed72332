import type { FarolEffect } from '../frame/FarolEffect';

/** A numeric setting of an effect, for menus and scene files. */
export interface EffectField {
  readonly kind: 'number';
  /** Name of the effect's property. */
  readonly property: string;
  /** Name of the setting in menus. */
  readonly label: string;
  /** One line of help on the setting. */
  readonly help: string;
  readonly default: number;
  /** SI unit of the setting; absent for a pure number. */
  readonly unit?: string;
  /** Smallest allowed value of the setting. */
  readonly min: number;
  readonly max: number;
  readonly step: number;
}

/** Class of an effect; without arguments it has the defaults. */
type EffectClass = new () => FarolEffect;

/** A colour of an effect, for menus and scene files; the effect's property is a `Color` of three's. */
export interface EffectColour {
  readonly kind: 'colour';
  /** Name of the effect's property. */
  readonly property: string;
  /** Name of the colour in menus. */
  readonly label: string;
  /** One line of help on the colour. */
  readonly help: string;
  /** Linear red, green and blue. */
  readonly default: [number, number, number];
}

/** Entry of an effect for menus and scene files; `load` fetches its code. */
export interface EffectEntry {
  /** Name of the effect in menus. */
  readonly label: string;
  /** One line of help on the effect. Default: none, where the label says all. */
  readonly help?: string;
  /** Group of effects of which at most one is used at a time. Default: no group. */
  readonly group?: 'antialiasing';
  /** Name of the effect's switch in the settings of a scene. Default: no switch. */
  readonly setting?: string;
  /** Short name of the switch, for URLs. Default: `setting`. */
  readonly short?: string;
  /** Numbers and colours that menus set, by their names in the settings of a scene. */
  readonly fields?: Readonly<Record<string, EffectField | EffectColour>>;
  /**
   * Buffer that the technique must fill before it shades; a technique that cannot leaves the effect out. Default: none.
   */
  readonly needs?: 'depth' | 'gbuffer';
  /** Number of frames after which the picture of a still scene no longer changes. Default 1. */
  readonly stillFrames?: number;
  /** Fetches the class of the effect. @throws Error (as a rejection) when that fails; a later call tries again */
  load(): Promise<EffectClass>;
}

const decals = () => import('./decals');
const ambientOcclusion = () => import('./ambient-occlusion');
const transparency = () => import('./transparency');
const volumetricFog = () => import('./volumetric-fog');
const antialiasing = () => import('./antialiasing');

/**
 * The effects that a menu offers, by key, in their order in `FarolRenderer.effects`. A new effect is a file and an entry here.
 * `Particles` is not listed: scenes with emitters always have it.
 */
export const effects = {
  decals: {
    label: 'Decals',
    needs: 'gbuffer',
    load: async () => (await decals()).Decals,
  },
  'ambient-occlusion': {
    label: 'Ambient occlusion',
    help: 'Indirect light reaches less into corners; "Automatic" then takes a technique with a G-buffer.',
    setting: 'ambientOcclusion',
    short: 'ao',
    needs: 'depth',
    fields: {
      occlusionRadius: {
        kind: 'number',
        property: 'radius',
        default: 0.5,
        unit: 'm',
        min: 0.01,
        max: 100,
        step: 0.05,
        help: 'Distance within which surfaces darken a corner.',
        label: 'Occlusion radius',
      },
      occlusionStrength: {
        kind: 'number',
        property: 'strength',
        default: 1,
        min: 0,
        max: 4,
        step: 0.05,
        help: 'How dark corners become; 1 is as computed.',
        label: 'Occlusion strength',
      },
    },
    load: async () => (await ambientOcclusion()).AmbientOcclusion,
  },
  'order-independent-transparency': {
    label: 'Unsorted transparency',
    help: 'Transparent layers are averaged, not sorted: they may pass through one another.',
    setting: 'unsortedTransparency',
    short: 'oit',
    load: async () => (await transparency()).WeightedBlendedOIT,
  },
  'volumetric-fog': {
    label: 'Volumetric fog',
    help: 'Fog that all lights light, with their shadows: halos, beams and shafts.',
    setting: 'volumetricFog',
    short: 'fog',
    stillFrames: 64,
    fields: {
      volumetricDensity: {
        kind: 'number',
        property: 'density',
        default: 0.03,
        unit: '1/m',
        min: 0,
        max: 10,
        step: 0.005,
        help: 'Share of light that is lost on a metre, for small values.',
        label: 'Fog density',
      },
      volumetricColour: {
        kind: 'colour',
        property: 'albedo',
        default: [1, 1, 1],
        help: 'Share of light that the fog scatters; the rest is absorbed.',
        label: 'Fog scattering',
      },
      volumetricAnisotropy: {
        kind: 'number',
        property: 'anisotropy',
        default: 0.3,
        min: -0.95,
        max: 0.95,
        step: 0.05,
        help: 'Above 0 fog scatters light forwards, and lamps have halos; below 0 backwards.',
        label: 'Fog anisotropy',
      },
      volumetricHeight: {
        kind: 'number',
        property: 'height',
        default: 0,
        unit: 'm',
        min: -10000,
        max: 10000,
        step: 0.5,
        help: 'Height up to which the fog has its density.',
        label: 'Fog height',
      },
      volumetricFalloff: {
        kind: 'number',
        property: 'falloff',
        default: 0,
        unit: 'm',
        min: 0,
        max: 10000,
        step: 0.5,
        help: 'Rise above the height over which density falls to about a third; 0: it does not fall.',
        label: 'Fog falloff',
      },
      volumetricNoise: {
        kind: 'number',
        property: 'noise',
        default: 0,
        min: 0,
        max: 1,
        step: 0.05,
        help: 'How much drifting clouds vary the density.',
        label: 'Fog noise',
      },
      volumetricNoiseSize: {
        kind: 'number',
        property: 'noiseSize',
        default: 4,
        unit: 'm',
        min: 0.1,
        max: 1000,
        step: 0.5,
        help: 'Size of the clouds.',
        label: 'Fog noise size',
      },
      volumetricDistance: {
        kind: 'number',
        property: 'distance',
        default: 100,
        unit: 'm',
        min: 1,
        max: 10000,
        step: 5,
        help: 'Distance at which fog ends; the nearer, the finer.',
        label: 'Fog distance',
      },
    },
    load: async () => (await volumetricFog()).VolumetricFog,
  },
  smaa: {
    label: 'SMAA',
    group: 'antialiasing',
    load: async () => (await antialiasing()).SMAA,
  },
  edges: {
    label: 'Multisampled edges',
    group: 'antialiasing',
    load: async () => (await antialiasing()).MultisampledEdges,
  },
  taa: {
    label: 'TAA',
    group: 'antialiasing',
    stillFrames: 40,
    load: async () => (await antialiasing()).TAA,
  },
} as const satisfies Record<string, EffectEntry>;

/** Names of the effects that Farol has. */
export type EffectName = keyof typeof effects;

/** The classes of all effects, fetched. @throws Error (as a rejection) when one cannot be fetched; try again */
export async function loadEffects(): Promise<Record<EffectName, EffectClass>> {
  const entries = Object.entries<EffectEntry>(effects);
  const classes = entries.map(async ([name, { load }]): Promise<[string, EffectClass]> => [name, await load()]);
  return Object.fromEntries(await Promise.all(classes)) as Record<EffectName, EffectClass>;
}
