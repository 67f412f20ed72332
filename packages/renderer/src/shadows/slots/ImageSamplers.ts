import type { Texture } from 'three';
import type { CookieSlot } from './CookieSlot';

/** Textures that a fragment shader can have, from which on four of them are for images. */
const MANY_UNITS = 32;

/** How many textures of lights a shader samples beside the maps of a material. @param units - textures that it can have */
export function imageSamplersOf(units: number): number {
  return units >= MANY_UNITS ? 4 : 1;
}

/**
 * Which of the textures that spot lights throw are sampled themselves, as three does it; others are copied. A texture keeps
 * its sampler as long as a light throws it, so that its picture does not change with other lights.
 */
export class ImageSamplers {
  /** The texture of each sampler, null while there is none. */
  readonly textures: (Texture | null)[];

  constructor(count: number) {
    this.textures = Array.from({ length: count }, () => null);
  }

  /** Gives lit images the samplers that are free. @param frame - number of the frame, as `CookieSlot.lastLit` has it */
  assign(images: ReadonlyMap<Texture, CookieSlot>, frame: number): void {
    const { textures } = this;
    for (let i = 0; i < textures.length; i++) {
      const texture = textures[i];
      if (texture === null) continue;
      const image = images.get(texture);
      if (image?.lastLit === frame) continue;
      if (image !== undefined) image.sampler = -1;
      textures[i] = null;
    }
    for (const image of images.values()) {
      if (image.lastLit !== frame || image.isCube || image.sampler >= 0) continue;
      image.sampler = textures.indexOf(null);
      if (image.sampler < 0) return;
      textures[image.sampler] = image.texture;
    }
  }

  clear(): void {
    this.textures.fill(null);
  }
}
