import type { FarolEffect } from '../frame/FarolEffect';
import { AmbientOcclusion } from './ambient-occlusion';
import { MultisampledEdges, SMAA, TAA } from './antialiasing';
import { Decals } from './decals';
import { WeightedBlendedOIT } from './transparency';

/** An effect as a menu shows it. */
export interface EffectEntry {
  /** Name in menus. */
  readonly label: string;
  /** One line of help. */
  readonly help: string;
  /** Of the entries of one group at most one is used at a time; null for those that stand alone. */
  readonly group: 'antialiasing' | null;
  /** A new effect, with its defaults. */
  make(): FarolEffect;
}

/**
 * The effects that a menu offers, by key, in the order in which they are to stand in `FarolRenderer.effects`. A new one is a file
 * and a line here. `Particles` is not among them: whoever has emitters has it too, and scenes without need not fetch it.
 */
export const effects = {
  decals: {
    label: 'Decals',
    help: 'Draws the decals of the scene on the surfaces in their boxes; needs a technique with a G-buffer.',
    group: null,
    make: () => new Decals(),
  },
  'ambient-occlusion': {
    label: 'Ambient occlusion',
    help: 'Indirect light reaches less into corners; needs a technique that knows depth before it shades.',
    group: null,
    make: () => new AmbientOcclusion(),
  },
  'order-independent-transparency': {
    label: 'Order-independent transparency',
    help: 'Transparent layers are averaged, not sorted: they may pass through one another.',
    group: null,
    make: () => new WeightedBlendedOIT(),
  },
  smaa: {
    label: 'SMAA',
    help: 'Smooths the edges of each picture by itself.',
    group: 'antialiasing',
    make: () => new SMAA(),
  },
  edges: {
    label: 'Multisampled edges',
    help: 'Draws the geometry once more, with 4 samples a pixel, and shades what edges hide: as antialias does.',
    group: 'antialiasing',
    make: () => new MultisampledEdges(),
  },
  taa: {
    label: 'TAA',
    help: 'Smooths edges over several frames, each drawn a part of a pixel off.',
    group: 'antialiasing',
    make: () => new TAA(),
  },
} as const satisfies Record<string, EffectEntry>;

export type EffectName = keyof typeof effects;
