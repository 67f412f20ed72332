/**
 * Depth test that cuts the light list of a screen tile: none; the nearest and farthest depth in the tile and the largest
 * gap between them; or also which of 32 depth slices between those hold surfaces.
 */
export type TileDepthUse = 'none' | 'bounds' | 'slices';
