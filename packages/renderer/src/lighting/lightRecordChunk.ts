import { extensionRecord, lightRecord, RECORDS_PER_ROW, TEXELS_PER_RECORD } from '../lights/lightRecord';
import { recordGetters } from './recordGetters';

const ROW_SHIFT = Math.log2(RECORDS_PER_ROW);

/** The microshader `lightRecord`: the light table's texture, and a function for each value of its records. */
export const lightRecordChunk = `// Reads the records of the light table.
// Farol; made from the tables in lights/lightRecord.ts
uniform highp sampler2D farol_lightTable;
vec4 farol_lightTexel(int record, int texel) {
  ivec2 at = ivec2((record & ${RECORDS_PER_ROW - 1}) * ${TEXELS_PER_RECORD} + texel, record >> ${ROW_SHIFT});
  return texelFetch(farol_lightTable, at, 0);
}
${recordGetters('light', lightRecord)}
${recordGetters('extension', extensionRecord)}
`;
