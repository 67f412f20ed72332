/** Hook for new LightFields: the renderer sets `tell`, which fetches the code that draws fields. */
export const lightFieldMade = { tell: (): unknown => null };
