/**
 * Pixels that a technique writes, so that three need not clear the target (a clear costs as much as a draw over all
 * pixels): 'every-pixel' writes colour and depth of every pixel; 'behind' writes the background's colour behind the
 * opaque items, so that only depth must be cleared.
 */
export type Fills = 'every-pixel' | 'behind';
