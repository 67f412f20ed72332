/** `tell` is called when a LightField is made; the renderer sets it, to fetch the code that draws fields. */
export const lightFieldMade = { tell: (): unknown => null };
