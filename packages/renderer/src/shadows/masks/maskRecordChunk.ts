import { TEXELS_PER_RECORD } from '../../lights/lightRecord';
import { recordGetters } from '../../lighting/recordGetters';
import { cookieShapes, FITS, maskRecord, RECORDS_PER_MASK, shadowLookups } from './maskLayout';

/** Offset of the record that holds the cascades' transforms, counted from the first record of a mask. */
const FIT_RECORD = 2;
const [first, second, third] = FITS.map((float) => float / 4 - FIT_RECORD * TEXELS_PER_RECORD);

/**
 * GLSL text of the microshader `maskRecord`: a function for each value of a light's mask record, and constants for its
 * codes.
 */
export const maskRecordChunk = `// Reads masks of lights: records of the light table.
// Farol; made from the tables in shadows/masks/maskLayout.ts
#include "lightRecord"
${constants('LOOKUP', shadowLookups)}
${constants('COOKIE', cookieShapes)}
const int FAROL_RECORDS_PER_MASK = ${RECORDS_PER_MASK};
${recordGetters('mask', maskRecord)}
vec4 farol_maskFit(const in int record, const in int cascade) {
  int texel = cascade == 0 ? ${first} : cascade == 1 ? ${second} : ${third};
  return farol_lightTexel(record + ${FIT_RECORD}, texel);
}
mat4 farol_maskMatrix(const in int record) {
  return mat4(farol_maskColumnX(record), farol_maskColumnY(record), farol_maskColumnZ(record), farol_maskColumnW(record));
}
`;

function constants(prefix: string, values: Readonly<Record<string, number>>): string {
  return Object.entries(values)
    .map(([name, value]) => `const int FAROL_${prefix}_${name.replace(/[A-Z]/g, '_$&').toUpperCase()} = ${value};`)
    .join('\n');
}
