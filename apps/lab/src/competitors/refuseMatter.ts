import { type LightKind, lightKinds, type Shading, shadings } from '../plan/lightKinds';
import type { RefusableScene } from './Competitor';

/** Reasons, each a sentence, why a competitor cannot draw certain kinds of lights and shadings. */
export interface Lacking {
  readonly kinds?: Readonly<Partial<Record<LightKind, string>>>;
  readonly shadings?: Readonly<Partial<Record<Shading, string>>>;
}

/** The first reason not to draw a case; null if there is none. */
export function refuseMatter({ kind, shading }: RefusableScene, lacking: Lacking): string | null {
  return lacking.kinds?.[kind] ?? lacking.shadings?.[shading] ?? null;
}

/** Kinds and shadings of Farol that three's renderers lack. */
export const lackingInThree: Lacking = {
  kinds: {
    rectangles: 'Rectangles of three.js have no end: its picture would be another one.',
    profiles: 'three.js has light profiles for spot lights of its WebGPURenderer alone.',
    field: 'three.js has no LightField: each light is an object and a loop’s turn of its own.',
    particles: 'three.js has no particles that are lights.',
  },
  shadings: { gouraud: 'three.js has no Gouraud shading: it lights all materials in each pixel.' },
};

/** Reasons, for all other kinds of lights, of a competitor that is measured with point lights only. */
export function pointsAlone(who: string): Readonly<Partial<Record<LightKind, string>>> {
  const others = Object.entries(lightKinds).filter(([kind]) => kind !== 'points');
  return Object.fromEntries(
    others.map(([kind, { word }]) => [kind, `${who} measured with point lights alone, not with ${word}.`]),
  );
}

/** Reason why an engine whose materials are converted from three's cannot draw Gouraud shading. */
export const noGouraud = (who: string): Lacking['shadings'] => ({
  gouraud: `The Lab has no ${shadings.gouraud.word} for ${who}.`,
});
