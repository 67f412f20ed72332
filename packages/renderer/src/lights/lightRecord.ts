/**
 * Layout of the light table: a texture of RGBA32F texels, `TEXELS_PER_RECORD` a record, `RECORDS_PER_ROW` records a row.
 *
 * | texel | directional | local |
 * |---|---|---|
 * | 0 | direction to the light (view space), 0 | centre (view space, m), range (m, 0: none) |
 * | 1 | colour × intensity, 1 if extended or masked | colour × intensity, decay if a plain point light, else -1 - decay |
 * | 2 | – | axis from target to light (view space), cosine of the cutoff angle |
 * | 3 | –, –, mask record or 0, extension record or 0 | cosine of the penumbra (-2: a point light), spot exponent or -1, mask record or 0, extension record or 0 |
 *
 * Of a point light that is elsewhere than its mask, both records have a half more, which integers lose: it is not taken for one
 * that may go the short way.
 *
 * An extension record holds what only a light of the thesis has: 0 diffuse scale, 1 specular scale, 2 ambient colour,
 * 3 attenuation parameters (near, far | constant, linear, quadratic) and kind (0 physical, 1 near-far, 2 polynomial).
 *
 * A mask takes `RECORDS_PER_MASK` records: what a shadow map and a cookie let through of a light, see masks/maskRecord.ts.
 */
export const TEXELS_PER_RECORD = 4;
export const RECORDS_PER_ROW = 256;
export const FLOATS_PER_RECORD = TEXELS_PER_RECORD * 4;
