/** Depths that lists are cut by: none, a tile's nearest and farthest, or also which of 32 slices between hold surfaces. */
export type TileDepthUse = 'none' | 'bounds' | 'slices';
