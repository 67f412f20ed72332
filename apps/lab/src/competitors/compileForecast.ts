import { smallFirstFrame } from './smallFirstFrame';

/** Numbers of lights that are tried. */
const TRIED = [16, 64] as const;
/** Growth by lights that is believed: compilers are no better than linear, hardly worse than cubic. */
const SLOPES = [1, 3] as const;

let tried: readonly number[] | null = null;

/**
 * Foretells how long three's shader takes to compile with that many lights (ms), by compiling it with few: on some devices
 * it is minutes, in which the page would hang.
 */
export function compileForecast(lights: number): number {
  tried ??= TRIED.map(smallFirstFrame);
  const slope = Math.log(tried[1] / tried[0]) / Math.log(TRIED[1] / TRIED[0]);
  return tried[1] * (lights / TRIED[1]) ** Math.min(SLOPES[1], Math.max(SLOPES[0], slope));
}
