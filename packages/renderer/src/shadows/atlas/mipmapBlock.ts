/**
 * Width of the border round each mipmap level of a texture copied into an atlas (texels); it holds the texels that the
 * texture's wrapping puts there.
 */
export const LEVEL_BORDER = 1;

const side = (length: number, level: number) => Math.max(1, length >> level);

/** Width of a texture's mipmaps in an atlas (texels): the first level, and beside it a column of the others. */
export function mipmapBlockWidth(width: number, levels: number): number {
  return width + 2 * LEVEL_BORDER + (levels > 1 ? side(width, 1) + 2 * LEVEL_BORDER : 0);
}

/** Height of a texture's mipmaps in an atlas (texels). */
export function mipmapBlockHeight(height: number, levels: number): number {
  return Math.max(height + 2 * LEVEL_BORDER, levelBottom(height, levels));
}

/**
 * Offset of a mipmap level in the column of levels, to its lower border (texels); for `level` = number of levels, the
 * height of the column.
 */
export function levelBottom(height: number, level: number): number {
  let bottom = 0;
  for (let i = 1; i < level; i++) bottom += side(height, i) + 2 * LEVEL_BORDER;
  return bottom;
}
