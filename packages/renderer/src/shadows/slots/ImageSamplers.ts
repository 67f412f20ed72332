import type { Texture } from 'three';
import type { CookieSlot } from './CookieSlot';

/** Number of a fragment shader's texture units from which on four are used for cookies of spot lights. */
const MANY_UNITS = 32;

/**
 * Number of lights' textures that a shader samples besides a material's maps.
 * @param units - texture units of fragment shaders
 */
export function imageSamplersOf(units: number): number {
  return units >= MANY_UNITS ? 4 : 1;
}

/**
 * Assigns samplers to textures that spot lights project, as three does; textures without a sampler are copied. A texture keeps
 * its sampler as long as a light projects it, so that other lights do not change its look.
 */
export class ImageSamplers {
  /** Texture of each sampler; null while the sampler is free. */
  readonly textures: (Texture | null)[];

  constructor(count: number) {
    this.textures = Array.from({ length: count }, () => null);
  }

  /** Gives the cookies of the frame the free samplers. @param frame - number of the frame, as in `CookieSlot.lastLit` */
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
