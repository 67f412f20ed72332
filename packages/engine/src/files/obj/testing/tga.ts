/** A TGA with 24 or 32 bits per texel: red, green, blue and alpha, bottom row first. */
export function tga(width: number, height: number, texels: readonly number[][]): Uint8Array<ArrayBuffer> {
  const size = texels[0].length;
  const head = [0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, width, 0, height, 0, size * 8, size === 4 ? 8 : 0];
  return Uint8Array.from([...head, ...texels.flatMap(([r, g, b, ...a]) => [b, g, r, ...a])]);
}
