/** Greatest depth of a scene's object tree. three traverses recursively, and overflows the stack at about 2,500. */
export const maximumDepth = 500;
