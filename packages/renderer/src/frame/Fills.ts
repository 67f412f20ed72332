/**
 * Pixels that a technique writes itself, so that three need not clear them (a clear costs as much as drawing all pixels):
 * 'every-pixel': colour and depth of every pixel; 'behind': the background's colour behind the opaque items, so that only depth
 * must be cleared.
 */
export type Fills = 'every-pixel' | 'behind';
