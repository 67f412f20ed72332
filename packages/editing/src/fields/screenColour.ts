import type { Vector3Tuple } from './Field';

/** The sRGB transfer function. @param linear - 0 to 1 @see IEC 61966-2-1 */
const encode = (linear: number): number => (linear <= 0.0031308 ? linear * 12.92 : 1.055 * linear ** (1 / 2.4) - 0.055);

const decode = (encoded: number): number => (encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4);

const HEX = /^#?([0-9a-f]{6}|[0-9a-f]{3})$/i;

/** Linear colour split into a colour that a screen can display, and a brightness factor. */
export interface ScreenColour {
  /** sRGB colour as '#rrggbb', to be multiplied by `intensity`. */
  readonly hex: string;
  /** Factor of the linear channels, 1 or more: above 1 one channel of `hex` is 'ff'. */
  readonly intensity: number;
}

/** Splits a linear colour into a screen colour and a brightness factor. */
export function splitColour([r, g, b]: Vector3Tuple): ScreenColour {
  const intensity = Math.max(1, r, g, b);
  const byte = (channel: number): string =>
    Math.round(255 * encode(Math.max(0, channel) / intensity))
      .toString(16)
      .padStart(2, '0');
  return { hex: `#${byte(r)}${byte(g)}${byte(b)}`, intensity };
}

/** Linear colour of a screen colour '#rrggbb' or '#rgb', times a factor; null for an invalid text. */
export function joinColour(hex: string, intensity: number): Vector3Tuple | null {
  const digits = HEX.exec(hex.trim())?.[1];
  if (!digits) return null;
  const long = digits.length === 3 ? [...digits].map((digit) => digit + digit).join('') : digits;
  const channel = (i: number): number => decode(Number.parseInt(long.slice(i, i + 2), 16) / 255) * intensity;
  return [channel(0), channel(2), channel(4)];
}

/**
 * Update for `FieldGesture` that sets the screen colour; each owner keeps its intensity from the start of the gesture.
 * Null for an invalid text.
 */
export function withScreenColour(hex: string): ((before: Vector3Tuple) => Vector3Tuple) | null {
  if (!joinColour(hex, 1)) return null;
  return (before) => joinColour(hex, splitColour(before).intensity)!;
}

/**
 * Update for `FieldGesture` that sets a colour's intensity and keeps its hue. The brightest channel is scaled to the
 * intensity; at 1, colours that a screen can display are not changed.
 * @param intensity - 1 or more
 * @throws RangeError for a smaller or infinite one
 */
export function withIntensity(intensity: number): (before: Vector3Tuple) => Vector3Tuple {
  if (!(intensity >= 1 && intensity < Infinity))
    throw new RangeError('The intensity is below 1 or no number: give a number of at least 1.');
  return ([r, g, b]) => {
    const brightest = Math.max(r, g, b);
    if (brightest <= 0 || (intensity === 1 && brightest <= 1)) return [r, g, b];
    const factor = intensity / brightest;
    return [r * factor, g * factor, b * factor];
  };
}

/** Colour and intensity shared by several colours; null for the part that differs. @param colours - at least one */
export function sharedColour(colours: readonly Vector3Tuple[]): { hex: string | null; intensity: number | null } {
  const [first, ...others] = colours.map(splitColour);
  return {
    hex: others.every(({ hex }) => hex === first.hex) ? first.hex : null,
    intensity: others.every(({ intensity }) => intensity === first.intensity) ? first.intensity : null,
  };
}
