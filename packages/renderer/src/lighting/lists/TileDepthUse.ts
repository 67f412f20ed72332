/**
 * Depth test that cuts the light list of a screen tile: none; the nearest and farthest depth in the tile; or also which
 * of 32 depth slices between those hold surfaces.
 */
export type TileDepthUse = 'none' | 'bounds' | 'slices';
