/**
 * Depth test for the light list of a screen tile: none; by the nearest and farthest depth in the tile and the largest gap
 * between them; or also by which of 32 slices between them hold surfaces.
 */
export type TileDepthUse = 'none' | 'bounds' | 'slices';
