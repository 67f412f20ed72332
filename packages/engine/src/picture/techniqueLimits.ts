import type { Technique } from '@farol/renderer/authoring';

/** Abilities that a technique lacks. */
export interface TechniqueLimits {
  /** It knows no depth before it shades: ambient occlusion is left out. */
  readonly occlusion: boolean;
  /** It shades a G-buffer, one sample a pixel: edges are smoothed by an effect or not at all. */
  readonly samples: boolean;
  /** It has no G-buffer: decals are not seen. */
  readonly decals: boolean;
}

const none: TechniqueLimits = { occlusion: false, samples: false, decals: false };
const known = new WeakMap<Technique, TechniqueLimits>();

function limitsOf({ writes, passes, lazy, lightOrder, fills }: Technique): TechniqueLimits {
  const fetches = lazy !== undefined || lightOrder !== 'by-volume';
  const written = writes ?? (fetches ? [] : passes().flatMap((pass) => pass.writes));
  const hasGBuffer = written.includes('gbuffer');
  return {
    occlusion: !hasGBuffer && !written.includes('scene-depth'),
    samples: hasGBuffer && fills === 'every-pixel',
    decals: !hasGBuffer,
  };
}

/**
 * Abilities that a technique lacks, by the resources that it writes.
 * @param techniques - `FarolRenderer.techniques`
 * @param name - of one of them; of one that is not there nothing is said
 */
export function techniqueLimits(techniques: Readonly<Record<string, Technique>>, name: string): TechniqueLimits {
  if (!Object.hasOwn(techniques, name)) return none;
  const technique = techniques[name];
  let limits = known.get(technique);
  if (limits === undefined) known.set(technique, (limits = limitsOf(technique)));
  return limits;
}
