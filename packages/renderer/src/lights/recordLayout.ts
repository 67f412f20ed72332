/**
 * What the four numbers of a texel mean, by name: which of them a value is (`'xyz'`), or its type in GLSL and an
 * expression in which `t` is the texel.
 */
export type TexelValues = Readonly<Record<string, string | readonly [type: string, expression: string]>>;

/** The texels of a record of a float texture, by name, in order. */
export type RecordLayout = Readonly<Record<string, TexelValues>>;

/** Where each texel of a record begins (floats from the record's start). */
export function texelOffsets<Layout extends RecordLayout>(
  layout: Layout,
): { readonly [texel in keyof Layout]: number } {
  const offsets = Object.keys(layout).map((texel, i) => [texel, i * 4] as const);
  return Object.fromEntries(offsets) as { [texel in keyof Layout]: number };
}
