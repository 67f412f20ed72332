import { splitColour } from '@farol/editing';
import { colourKeys, type Gradient, gradientAt } from '@farol/engine/fields';

/** Number of stops added between two keys, to approximate interpolation in linear light, which CSS does not do. */
const BETWEEN = 6;

/** A gradient as CSS. @param isOpaque - whether to leave opacity out */
export function gradientCss(gradient: Gradient, isOpaque = false): string {
  const keys = isOpaque ? colourKeys(gradient) : gradient;
  const times = new Set([0, 1]);
  keys.forEach(([time], i) => {
    times.add(time);
    const to = keys[i + 1]?.[0] ?? time;
    for (let n = 1; n < BETWEEN; n++) times.add(time + ((to - time) * n) / BETWEEN);
  });
  const stops = [...times]
    .toSorted((a, b) => a - b)
    .map((time) => {
      const { colour, opacity } = gradientAt(gradient, time);
      const alpha = isOpaque ? 'ff' : hexByte(opacity);
      return `${splitColour(colour).hex}${alpha} ${Number((time * 100).toFixed(2))}%`;
    });
  return `linear-gradient(90deg, ${stops.join(', ')})`;
}

const hexByte = (share: number): string =>
  Math.round(share * 255)
    .toString(16)
    .padStart(2, '0');
