/**
 * Width of the border round each mipmap level of a texture copied into an atlas, for a cube round each face (texels); holds the
 * texels that the texture's wrapping, or the next face, puts there.
 */
export const LEVEL_BORDER = 1;

/**
 * Width of a texture's mipmaps in an atlas (texels): the first level, above it the second, and to the right of that a
 * column of the others.
 * @param width - of a face (texels)
 * @param faces - number of faces across: 1, or 3 for a cube
 */
export function mipmapBlockWidth(width: number, levels: number, faces = 1): number {
  const above = levels > 2 ? levelSpan(width, 1, faces) + levelSpan(width, 2, faces) : 0;
  return Math.max(levelSpan(width, 0, faces), above);
}

/**
 * Height of a texture's mipmaps in an atlas (texels).
 * @param height - of a face (texels)
 * @param faces - number of faces up: 1, or 2 for a cube
 */
export function mipmapBlockHeight(height: number, levels: number, faces = 1): number {
  const second = levels > 1 ? levelSpan(height, 0, faces) + levelSpan(height, 1, faces) : 0;
  return Math.max(levelBottom(height, levels, faces), second);
}

/** Distance from the left edge of a texture's mipmaps in an atlas to the left border of a level (texels). */
export function levelLeft(width: number, level: number, faces = 1): number {
  return level > 1 ? levelSpan(width, 1, faces) : 0;
}

/** Distance from the lower edge of the mipmaps to a level's border (texels); for `level` = number of levels, to the top. */
export function levelBottom(height: number, level: number, faces = 1): number {
  let bottom = level > 0 ? levelSpan(height, 0, faces) : 0;
  for (let i = 2; i < level; i++) bottom += levelSpan(height, i, faces);
  return bottom;
}

/** Length of a level along one side, borders included (texels). */
export function levelSpan(length: number, level: number, faces = 1): number {
  return faces * (Math.max(1, length >> level) + 2 * LEVEL_BORDER);
}
