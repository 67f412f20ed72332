import type { Color } from 'three';

/** A group of lights that were drawn together. */
export interface Measured<Part> {
  readonly parts: readonly Part[];
  readonly color: Color;
}

/** Maximum size of a group that is split into single lights at once. */
const FEW = 4;

/** Relative luminance of linear RGB, by the magnitude of each channel, since lights may be negative. */
export const brightnessOf = ({ r, g, b }: Color): number =>
  0.2126 * Math.abs(r) + 0.7152 * Math.abs(g) + 0.0722 * Math.abs(b);

/** Lights measured one by one, and all others that give light, in groups. */
export interface BrightestParts<Part> {
  /** Single lights, brightest first. */
  readonly single: readonly Measured<Part>[];
  readonly rest: readonly Part[];
}

/**
 * Finds the brightest of many lights by few draws: groups of lights are drawn together, and the brightest group is split until
 * no group is brighter than the single lights found. Yields the share of the light found so far, 0 to 1, after each draw.
 * @param measure - draws a group, and returns its light
 * @param most - number of single lights to find, by at most 8 draws for each, plus 64
 */
export function* brightestParts<Part>(
  parts: readonly Part[],
  measure: (parts: readonly Part[]) => Color,
  most: number,
): Generator<number, BrightestParts<Part>> {
  // brightest last
  const known: Measured<Part>[] = [];
  const single: Measured<Part>[] = [];
  const draws = { left: 8 * most + 64 };
  const draw = (group: readonly Part[]): void => {
    draws.left--;
    const color = measure(group);
    const brightness = brightnessOf(color);
    if (brightness === 0) return;
    const at = known.findIndex((each) => brightnessOf(each.color) > brightness);
    known.splice(at < 0 ? known.length : at, 0, { parts: group, color });
  };
  if (parts.length > 0) draw(parts);
  const total = known.length > 0 ? brightnessOf(known[0].color) : 1;
  let found = 0;
  yield 0;
  while (known.length > 0 && single.length < most && draws.left > 0) {
    const brightest = known.pop()!;
    const { length } = brightest.parts;
    if (length === 1) {
      single.push(brightest);
      found += brightnessOf(brightest.color);
      continue;
    }
    const size = length <= FEW ? 1 : Math.ceil(length / 2);
    for (let i = 0; i < length; i += size) {
      draw(brightest.parts.slice(i, i + size));
      yield Math.min(1, found / total);
    }
  }
  for (let i = known.length - 1; i >= 0 && single.length < most; i--)
    if (known[i].parts.length === 1) single.push(...known.splice(i, 1));
  return { single, rest: known.flatMap((group) => group.parts) };
}
