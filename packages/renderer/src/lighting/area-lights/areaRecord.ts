import { type RecordLayout, texelOffsets } from '../../lights/recordLayout';
import { recordGetters } from '../recordGetters';

/** What an area light is, as its record says it. */
export const areaShapes = { rectangle: 0, disc: 1, tube: 2 } as const;

/** The extension record of an area light. Vectors in view space, of half its size (m). */
export const areaRecord = {
  across: {
    /** Of a tube: half its axis. */
    halfWidth: 'xyz',
    /** One of `areaShapes`. */
    shape: ['int', 'int(t.w)'],
  },
  up: {
    /** Of a tube: its radius long. */
    halfHeight: 'xyz',
    /** Distance from the surface of the light from which on it gives nothing (m). */
    reach: 'w',
  },
} as const satisfies RecordLayout;

/** Where the texels of the record begin (floats). */
export const AREA = texelOffsets(areaRecord);

/** The microshader `areaRecord`. */
export const areaRecordChunk = `// Reads the extensions of area lights: records of the light table.
// Farol; made from the table in lighting/area-lights/areaRecord.ts
#include "lightRecord"
${Object.entries(areaShapes)
  .map(([name, value]) => `const int FAROL_AREA_${name.toUpperCase()} = ${value};`)
  .join('\n')}
${recordGetters('area', areaRecord)}
`;
