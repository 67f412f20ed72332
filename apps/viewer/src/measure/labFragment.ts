import type { FieldValue } from '@farol/engine/fields';

/** Lights along the axis of the chart, as factors of those on show. */
const FACTORS = [0.25, 0.5, 1, 2, 4];

const numberOf = (value: FieldValue | undefined, otherwise: number): number =>
  typeof value === 'number' ? value : otherwise;

/** Counts of lights round those on show, ascending, each once. */
function lightsRound(lights: number): string {
  const counts = FACTORS.map((factor) => Math.min(10_000, Math.max(1, Math.round(lights * factor))));
  return [...new Set(counts)].join(',');
}

/**
 * What the Lab's address has after `#` to measure a demo scene over its lights, those on show in the middle:
 * `#preset=custom&series=temple:lights:12,25,50,100,200`.
 *
 * @param scene - key in the engine's `scenes`
 * @param parameters - of the scene on show; those absent have their defaults
 * @param defaults - of the scene's parameters
 * @returns null for a scene that the Lab does not build by itself
 */
export function labFragment(
  scene: string,
  parameters: Readonly<Record<string, FieldValue>>,
  defaults: Readonly<Record<string, { readonly default: FieldValue }>>,
): string | null {
  const value = (name: string): number => numberOf(parameters[name], numberOf(defaults[name]?.default, 0));
  if (scene === 'benchmarkLights') {
    return `#preset=custom&series=benchmarkLights:lights:${lightsRound(value('m') ** 2)}:n=${value('n')}`;
  }
  if (scene !== 'sponza' && scene !== 'temple') return null;
  return `#preset=custom&series=${scene}:lights:${lightsRound(value('lights'))}`;
}

/** What the Lab's address has after `#` to measure a scene that is handed over, from 360p to 1080p. */
export const ownSceneFragment = '#preset=custom&series=own:pixels:230,922,2074';
