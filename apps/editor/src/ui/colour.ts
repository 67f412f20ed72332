import type { Vector3Tuple } from '@farol/engine/fields';

/** The sRGB transfer function. @param linear - 0 to 1 @see IEC 61966-2-1 */
const encode = (linear: number): number => (linear <= 0.0031308 ? linear * 12.92 : 1.055 * linear ** (1 / 2.4) - 0.055);

const decode = (encoded: number): number => (encoded <= 0.04045 ? encoded / 12.92 : ((encoded + 0.055) / 1.055) ** 2.4);

const HEX = /^#?([0-9a-f]{6}|[0-9a-f]{3})$/i;

/** A linear colour as a screen colour of at most 1, and the factor by which it is brighter than that (1 or more). */
export function splitColour([r, g, b]: Vector3Tuple): { hex: string; intensity: number } {
  const intensity = Math.max(1, r, g, b);
  const byte = (channel: number): string =>
    Math.round(255 * encode(Math.min(1, channel / intensity)))
      .toString(16)
      .padStart(2, '0');
  return { hex: `#${byte(r)}${byte(g)}${byte(b)}`, intensity };
}

/** A linear colour of a screen colour '#rrggbb' or '#rgb', times a factor; null when it is none. */
export function joinColour(hex: string, intensity: number): Vector3Tuple | null {
  const digits = HEX.exec(hex.trim())?.[1];
  if (!digits) return null;
  const long = digits.length === 3 ? [...digits].map((digit) => digit + digit).join('') : digits;
  const channel = (i: number): number => decode(Number.parseInt(long.slice(i, i + 2), 16) / 255) * intensity;
  return [channel(0), channel(2), channel(4)];
}
