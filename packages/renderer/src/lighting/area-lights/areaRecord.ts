import { type RecordLayout, texelOffsets } from '../../lights/recordLayout';
import { recordGetters } from '../recordGetters';

/** Codes of an area light's shape in its record. */
export const areaShapes = { rectangle: 0, disc: 1, tube: 2 } as const;

/**
 * Layout of an area light's extension record in the light table. Vectors are in view space and span half the light's
 * size (m).
 */
export const areaRecord = {
  across: {
    /** Half the light's width; for a tube, half its axis. */
    halfWidth: 'xyz',
    /** Shape of the area light, one of `areaShapes`. */
    shape: ['int', 'int(t.w)'],
  },
  up: {
    /** Half the light's height; for a tube, a vector as long as its radius. */
    halfHeight: 'xyz',
    /** Distance from the light's surface beyond which it gives nothing (m). */
    reach: 'w',
  },
} as const satisfies RecordLayout;

/** Offset of each texel in an area light's extension record (floats). */
export const AREA = texelOffsets(areaRecord);

/** GLSL text of the microshader `areaRecord`: functions that read an area light's extension record. */
export const areaRecordChunk = `// Reads the extensions of area lights: records of the light table.
// Farol; made from the table in lighting/area-lights/areaRecord.ts
#include "lightRecord"
${Object.entries(areaShapes)
  .map(([name, value]) => `const int FAROL_AREA_${name.toUpperCase()} = ${value};`)
  .join('\n')}
${recordGetters('area', areaRecord)}
`;
