/**
 * Named values in a texel's four numbers: components of the texel (`'xyz'`), or a GLSL type and an expression in which `t` is
 * the texel.
 */
export type TexelValues = Readonly<Record<string, string | readonly [type: string, expression: string]>>;

/** The texels of a record of a float texture, by name, in order. */
export type RecordLayout = Readonly<Record<string, TexelValues>>;

/** Offset of each texel of a record (floats from the record's start). */
export function texelOffsets<Layout extends RecordLayout>(
  layout: Layout,
): { readonly [texel in keyof Layout]: number } {
  const offsets = Object.keys(layout).map((texel, i) => [texel, i * 4] as const);
  return Object.fromEntries(offsets) as { [texel in keyof Layout]: number };
}
