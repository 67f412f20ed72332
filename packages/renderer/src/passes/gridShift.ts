/**
 * How far a picture is to be moved (pixels, 0 to 1) so that texel centres of a smaller buffer fall on pixel centres: at
 * half the resolution a texel's centre would lie between four pixels, and every pixel would be interpolated.
 * @param pixels of the picture, along one side
 * @param texels of the buffer, at most as many
 */
export function gridShift(pixels: number, texels: number): number {
  return (0.5 * (pixels / texels) - 0.5) % 1;
}
