import type { Vector3Tuple } from '@farol/editing/fields';

/** A bright linear colour of a hue from 0 to 1, its brightest channel 1. @param saturation - 0 white to 1 pure */
export function hueColour(hue: number, saturation = 0.75): Vector3Tuple {
  const wave = (shift: number): number => 0.5 + 0.5 * Math.cos(2 * Math.PI * (hue - shift / 3));
  const pure = [wave(0), wave(1), wave(2)];
  const brightest = Math.max(...pure);
  const channel = (value: number): number => 1 - saturation + (saturation * value) / brightest;
  return [channel(pure[0]), channel(pure[1]), channel(pure[2])];
}
