import type { Vector3Tuple } from '@farol/engine/fields';
import { Color, SRGBColorSpace } from 'three';

const colour = new Color();

/** A linear colour as '#rrggbb' of the screen, channels above 1 cut. */
export function screenColour([r, g, b]: Vector3Tuple): string {
  const cut = (channel: number) => Math.min(1, Math.max(0, channel));
  return `#${colour.setRGB(cut(r), cut(g), cut(b)).getHexString(SRGBColorSpace)}`;
}

/** '#rrggbb' of the screen as a linear colour. */
export function linearColour(hex: string): Vector3Tuple {
  const { r, g, b } = colour.set(hex);
  return [r, g, b];
}
