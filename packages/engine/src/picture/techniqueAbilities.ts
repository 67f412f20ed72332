import type { Technique } from '@farol/renderer/authoring';

/** Abilities of a technique that effects depend on. */
export interface TechniqueAbilities {
  /** It knows depth before it shades. Without it ambient occlusion is left out. */
  readonly depth: boolean;
  /** It has a G-buffer. Without it decals are not seen. */
  readonly gbuffer: boolean;
  /** It shades as many samples a pixel as the target has. Without it edges are smoothed by an effect or not at all. */
  readonly samples: boolean;
}

const all: TechniqueAbilities = { depth: true, gbuffer: true, samples: true };
const known = new WeakMap<Technique, TechniqueAbilities>();

function abilitiesOf({ writes, passes, lazy, lightOrder, fills }: Technique): TechniqueAbilities {
  const fetches = lazy !== undefined || lightOrder !== 'by-volume';
  const written = writes ?? (fetches ? [] : passes().flatMap((pass) => pass.writes));
  const gbuffer = written.includes('gbuffer');
  return { depth: gbuffer || written.includes('scene-depth'), gbuffer, samples: !gbuffer || fills !== 'every-pixel' };
}

/**
 * Abilities of a technique, by the resources that it writes.
 * @param techniques - `FarolRenderer.techniques`
 * @param name - of one of them; one that is not there is taken to be able to do all
 */
export function techniqueAbilities(techniques: Readonly<Record<string, Technique>>, name: string): TechniqueAbilities {
  if (!Object.hasOwn(techniques, name)) return all;
  const technique = techniques[name];
  let abilities = known.get(technique);
  if (abilities === undefined) known.set(technique, (abilities = abilitiesOf(technique)));
  return abilities;
}
