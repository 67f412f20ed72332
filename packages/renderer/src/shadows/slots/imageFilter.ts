import { LinearFilter, LinearMipmapLinearFilter, NearestFilter, NearestMipmapLinearFilter, type Texture } from 'three';
import { LinearMipmapNearestFilter, NearestMipmapNearestFilter } from 'three';

/**
 * Filtering of a cookie, as bits of a whole number: index of the first bit of `levels` and `anisotropy`; lightImage.glsl repeats
 * these numbers.
 */
export const FILTER_BITS = { levels: 4, anisotropy: 8 } as const;

/**
 * Number of mipmap levels that three has on the GPU, for a copy of the given size; 1 if the texture's filter uses none.
 */
export function imageLevels(texture: Texture, width: number, height: number, copied: number): number {
  const { minFilter, generateMipmaps } = texture;
  if (minFilter === NearestFilter || minFilter === LinearFilter) return 1;
  const all = 1 + Math.floor(Math.log2(Math.max(width, height)));
  // compressed cube textures have mipmaps in each face
  const given = Array.isArray(texture.image) ? texture.image[0].mipmaps : texture.mipmaps;
  const there = generateMipmaps ? all : Math.max(1, given?.length ?? 1);
  // a smaller copy begins with a later mipmap level
  return Math.max(1, there - Math.round(Math.log2(width / copied)));
}

/**
 * Packs filters, levels and anisotropy of a texture into one number, by `FILTER_BITS`.
 * @param most - anisotropy of the device
 */
export function imageFilter(texture: Texture, levels: number, most: number): number {
  const { minFilter, magFilter, anisotropy } = texture;
  const betweenLevels = minFilter === NearestMipmapLinearFilter || minFilter === LinearMipmapLinearFilter;
  const ofOneLevel = minFilter === NearestMipmapNearestFilter || minFilter === LinearMipmapNearestFilter;
  const isNearest =
    minFilter === NearestFilter || minFilter === NearestMipmapNearestFilter || minFilter === NearestMipmapLinearFilter;
  // three leaves the anisotropy of other filters at 1
  const taps = magFilter !== NearestFilter && betweenLevels ? Math.min(anisotropy, most) : 1;
  return (
    (magFilter === NearestFilter ? 1 : 0) +
    (isNearest ? 2 : 0) +
    (betweenLevels ? 8 : ofOneLevel ? 4 : 0) +
    ((levels - 1) << FILTER_BITS.levels) +
    (taps << FILTER_BITS.anisotropy)
  );
}
