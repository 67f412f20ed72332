/**
 * Precision statements of Farol's code: depths, positions and 32-bit words need it, whatever the host's materials use.
 */
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

/** Wraps Farol's declarations in a fragment shader of three's: full precision for them, the host's again after them. */
export const inFullPrecision = (header: string): string => (header === '' ? '' : `${FULL_PRECISION}${header}\n${BACK}`);
