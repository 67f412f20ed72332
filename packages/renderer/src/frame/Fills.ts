/**
 * How a technique spares three a clear of the target, which costs as much as a draw over all pixels: 'every-pixel' writes
 * colour and depth of every pixel, so that neither need be cleared; 'behind' writes the background's colour behind the
 * opaque items once they are drawn, so that colour need not be.
 */
export type Fills = 'every-pixel' | 'behind';
