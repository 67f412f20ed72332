import type { ColourKey, Curve, Gradient, GradientKey, Vector3Tuple } from './Field';

/** Index of the first key after a time; the number of keys when there is none. */
function keyAfter(keys: readonly (readonly [number, ...unknown[]])[], time: number): number {
  let i = 0;
  while (i < keys.length && keys[i][0] <= time) i++;
  return i;
}

/** Interpolation factor (0 to 1) of a time between two keys' times. */
const shareOf = (from: number, to: number, time: number): number => (time - from) / (to - from);

/** The value of a curve at a time. */
export function curveAt(curve: Curve, time: number): number {
  const next = keyAfter(curve, time);
  if (next === 0) return curve[0][1];
  const [from, value] = curve[next - 1];
  if (next === curve.length) return value;
  return value + (curve[next][1] - value) * shareOf(from, curve[next][0], time);
}

/** The keys of a gradient that have a colour. */
export const colourKeys = (gradient: Gradient): ColourKey[] =>
  gradient.flatMap(([time, colour]) => (colour === null ? [] : [[time, colour] as const]));

/** The keys of a gradient that have an opacity, as a curve. */
export const opacityKeys = (gradient: Gradient): Curve =>
  gradient.flatMap(([time, , opacity]) => (opacity === null ? [] : [[time, opacity] as const]));

/** Joins colour keys and opacity keys, both by ascending time, to a gradient: keys of equal time become one key. */
export function joinKeys(colours: readonly ColourKey[], opacities: Curve): Gradient {
  const keys: GradientKey[] = [];
  for (let c = 0, o = 0; c < colours.length || o < opacities.length;) {
    const colourTime = colours[c]?.[0] ?? Infinity;
    const opacityTime = opacities[o]?.[0] ?? Infinity;
    const time = Math.min(colourTime, opacityTime);
    keys.push([time, colourTime === time ? colours[c++][1] : null, opacityTime === time ? opacities[o++][1] : null]);
  }
  return keys;
}

function colourAt(colours: readonly ColourKey[], time: number): Vector3Tuple {
  const next = keyAfter(colours, time);
  if (next === 0) return colours[0][1];
  const [from, a] = colours[next - 1];
  if (next === colours.length) return a;
  const [to, b] = colours[next];
  const share = shareOf(from, to, time);
  return [a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share];
}

/** The colour and the opacity of a gradient at a time. */
export const gradientAt = (gradient: Gradient, time: number): { colour: Vector3Tuple; opacity: number } => ({
  colour: colourAt(colourKeys(gradient), time),
  opacity: curveAt(opacityKeys(gradient), time),
});

/** A gradient with both colour and opacity in each of its keys. */
export function fullKeys(gradient: Gradient): (readonly [time: number, colour: Vector3Tuple, opacity: number])[] {
  const colours = colourKeys(gradient);
  const opacities = opacityKeys(gradient);
  return gradient.map(([time, colour, opacity]) => [
    time,
    colour ?? colourAt(colours, time),
    opacity ?? curveAt(opacities, time),
  ]);
}
