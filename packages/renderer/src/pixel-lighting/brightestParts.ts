import type { Color } from 'three';

/** Lights that were drawn together. */
export interface Measured<Part> {
  readonly parts: readonly Part[];
  readonly color: Color;
}

/** Groups of so many are split into single ones at once. */
const FEW = 4;

/** Relative luminance of linear RGB, by the magnitude of each channel: lights may take light away. */
export const brightnessOf = ({ r, g, b }: Color): number =>
  0.2126 * Math.abs(r) + 0.7152 * Math.abs(g) + 0.0722 * Math.abs(b);

/**
 * Finds the brightest of many lights by few draws: groups of lights are drawn together, and the brightest group is split until so
 * many single lights are known. Yields the part of the light that is known, 0 to 1, after each draw.
 * @param measure - light of a group
 * @param most - single lights to find
 * @returns single lights that give light, and groups that were not split, brightest first
 */
export function* brightestParts<Part>(
  parts: readonly Part[],
  measure: (parts: readonly Part[]) => Color,
  most: number,
): Generator<number, Measured<Part>[]> {
  const single: Measured<Part>[] = [];
  const open: Measured<Part>[] = [];
  let total = 0;
  let found = 0;
  const draw = (group: readonly Part[]): void => {
    if (group.length === 0) return;
    const color = measure(group);
    const brightness = brightnessOf(color);
    if (brightness === 0) return;
    if (group.length > 1) open.push({ parts: group, color });
    else {
      single.push({ parts: group, color });
      found += brightness;
    }
  };
  draw(parts);
  total = open.length > 0 ? brightnessOf(open[0].color) : found;
  yield 0;
  while (open.length > 0 && single.length < most) {
    let brightest = 0;
    for (let i = 1; i < open.length; i++)
      if (brightnessOf(open[i].color) > brightnessOf(open[brightest].color)) brightest = i;
    const [group] = open.splice(brightest, 1);
    const size = group.parts.length <= FEW ? 1 : Math.ceil(group.parts.length / 2);
    for (let i = 0; i < group.parts.length; i += size) {
      draw(group.parts.slice(i, i + size));
      yield Math.min(1, found / total);
    }
  }
  return [...single, ...open].toSorted((a, b) => brightnessOf(b.color) - brightnessOf(a.color));
}
