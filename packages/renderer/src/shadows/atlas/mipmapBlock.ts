/** Texels round each level of an image in an atlas, which hold what the image's wrapping has beside it. */
export const LEVEL_BORDER = 1;

const side = (length: number, level: number) => Math.max(1, length >> level);

/** Texels across the block of an image: the first level, and beside it a column of the others. */
export function mipmapBlockWidth(width: number, levels: number): number {
  return width + 2 * LEVEL_BORDER + (levels > 1 ? side(width, 1) + 2 * LEVEL_BORDER : 0);
}

/** Texels up the block of an image. */
export function mipmapBlockHeight(height: number, levels: number): number {
  return Math.max(height + 2 * LEVEL_BORDER, levelBottom(height, levels));
}

/** Texels below the lower border of a level, in its column; of `levels`: all of the column. */
export function levelBottom(height: number, level: number): number {
  let bottom = 0;
  for (let i = 1; i < level; i++) bottom += side(height, i) + 2 * LEVEL_BORDER;
  return bottom;
}
