/** Depths, positions and words of 32 bits need it, whatever the host's materials are computed in. */
export const FULL_PRECISION = 'precision highp float;\nprecision highp int;\n';

/**
 * Precision statement that three puts before its shaders, by the `precision` of renderer or material. Integers stay as
 * they are: three has few.
 */
const BACK = `#ifdef MEDIUM_PRECISION
precision mediump float;
#elif defined( LOW_PRECISION )
precision lowp float;
#endif
`;

/** Declarations of ours in a fragment shader of three's: in full precision, and those after it in the host's again. */
export const inFullPrecision = (header: string): string => (header === '' ? '' : `${FULL_PRECISION}${header}\n${BACK}`);
