import type { FieldValue } from '@farol/engine/fields';

/** Numbers of lights on the axis of the chart, as factors of the current number. */
const FACTORS = [0.25, 0.5, 1, 2, 4];

const numberOf = (value: FieldValue | undefined, otherwise: number): number =>
  typeof value === 'number' ? value : otherwise;

/** Numbers of lights around the current one, ascending, each once. */
function lightsRound(lights: number): string {
  const counts = FACTORS.map((factor) => Math.min(10_000, Math.max(1, Math.round(lights * factor))));
  return [...new Set(counts)].join(',');
}

/**
 * Fragment of the Lab's address that measures a demo scene for several numbers of lights around the current one:
 * `#preset=custom&series=temple:lights:12,25,50,100,200`.
 *
 * @param scene - key in the engine's `scenes`
 * @param parameters - values of the current scene; missing ones have their defaults
 * @param defaults - defaults of the scene's parameters
 * @returns null for a scene that the Lab cannot build
 */
export function labFragment(
  scene: string,
  parameters: Readonly<Record<string, FieldValue>>,
  defaults: Readonly<Record<string, { readonly default: FieldValue }>>,
): string | null {
  const value = (name: string): number => numberOf(parameters[name], numberOf(defaults[name]?.default, 0));
  if (scene === 'benchmarkLights') {
    const lights = value('m') * (value('mRows') || value('m'));
    return `#preset=custom&series=benchmarkLights:lights:${lightsRound(lights)}:n=${value('n')}`;
  }
  if (scene !== 'sponza' && scene !== 'temple') return null;
  return `#preset=custom&series=${scene}:lights:${lightsRound(value('lights'))}`;
}

/** Fragment of the Lab's address that measures a handed-over scene from 360p to 1080p. */
export const ownSceneFragment = '#preset=custom&series=own:pixels:230,922,2074';
