import type { Technique } from '@farol/renderer/authoring';

/** Abilities of a technique that effects depend on. */
export interface TechniqueAbilities {
  /** Whether depth is known before shading; without it ambient occlusion is left out. */
  readonly depth: boolean;
  /** Whether there is a G-buffer; without it decals are not drawn. */
  readonly gbuffer: boolean;
  /** Whether multisampling has an effect; without it, edges are smoothed by an anti-aliasing effect or not at all. */
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
 * Abilities of a technique, derived from the resources that it writes.
 * @param techniques - `FarolRenderer.techniques`
 * @param name - key of `techniques`; an unknown technique gets all abilities
 */
export function techniqueAbilities(techniques: Readonly<Record<string, Technique>>, name: string): TechniqueAbilities {
  if (!Object.hasOwn(techniques, name)) return all;
  const technique = techniques[name];
  let abilities = known.get(technique);
  if (abilities === undefined) known.set(technique, (abilities = abilitiesOf(technique)));
  return abilities;
}
