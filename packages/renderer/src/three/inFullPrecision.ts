/**
 * Precision statements of Farol's code: depths, positions and 32-bit words need full precision, whatever the host's materials
 * use.
 */
export const FULL_PRECISION = 'precision highp float;\nprecision highp int;\n';

/** Precision statement of three's shaders, by the `precision` of renderer or material. Integers remain highp. */
const BACK = `#ifdef MEDIUM_PRECISION
precision mediump float;
#elif defined( LOW_PRECISION )
precision lowp float;
#endif
`;

/** Wraps Farol's declarations for a fragment shader of three's: full precision for them, then the host's again. */
export const inFullPrecision = (header: string): string => (header === '' ? '' : `${FULL_PRECISION}${header}\n${BACK}`);
