import type { RecordLayout } from './recordLayout';

type Offsets<Layout extends RecordLayout> = { readonly [texel in keyof Layout]: number };

/**
 * The light table: a texture of RGBA32F texels, `TEXELS_PER_RECORD` a record, `RECORDS_PER_ROW` records a row. A light is one
 * record; data that few lights need are in separate records, behind all lights: a mask (`masks/maskRecord.ts`: the light's
 * shadow map and cookie) and an extension (options of the thesis's lights, or of area lights).
 *
 * The offsets for TypeScript below, and lightRecord.glsl with its getters, are made from the two tables: recordGetters.test.ts.
 */
export const TEXELS_PER_RECORD = 4;
export const RECORDS_PER_ROW = 256;
export const FLOATS_PER_RECORD = TEXELS_PER_RECORD * 4;

/** Number in place of a light's index, for a record that lights nothing. */
export const NO_LIGHT = 0xffffffff;

/** Cosines of cutoff and penumbra that mark a point light; no spot light has them. */
export const POINT_CUTOFF = -3;
export const POINT_PENUMBRA = -2;
/** Cosine of the penumbra that marks an area light. */
export const AREA_PENUMBRA = -3;
/** Spot exponent in the record of a light whose cone has three's penumbra instead. */
export const NO_EXPONENT = -1;
/**
 * Fraction added to a mask's record index in `details` if the point light has moved since its shadow map was drawn; shaders
 * truncate it.
 */
export const ELSEWHERE = 0.5;

/** Kinds of attenuation with distance, of a light with an extension record. */
export const attenuationKinds = { physical: 0, nearFar: 1, polynomial: 2 } as const;

/** A light's record in the light table. Vectors are in view space; lengths in metres; angles as cosines. */
export const lightRecord = {
  sphere: {
    /** Direction to a directional light, unit length. */
    direction: 'xyz',
    position: 'xyz',
    /** Range of a local light (m); 0 for one without a range. */
    range: 'w',
  },
  emission: {
    /** Linear colour × intensity of the light. */
    color: 'rgb',
    /**
     * For a local light: whether it is a plain point light, without mask or Farol's options; its cone and details are not
     * written.
     */
    isPlain: ['bool', 't.w >= 0.0'],
    plainDecay: 'w',
    /** Decay of a local light with a mask, a cone or an extension. */
    otherDecay: ['float', '-64.0 - t.w'],
    decay: ['float', 't.w >= 0.0 ? t.w : -64.0 - t.w'],
    /** Directional light: whether it has a mask or an extension. */
    hasDetails: ['bool', 't.w != 0.0'],
  },
  cone: {
    /** Direction from the target to the light, unit length. */
    axis: 'xyz',
    cutoff: 'w',
    isCone: ['bool', 't.w > -1.0'],
  },
  details: {
    penumbra: 'x',
    /** Exponent of the thesis's spot light, or NO_EXPONENT. */
    exponent: 'y',
    /** Index of the record of the light's mask (shadow map, cookie, profile); 0 for none. */
    maskRecord: ['int', 'int(t.z)'],
    extensionRecord: ['int', 'int(t.w)'],
    isSpot: ['bool', 't.x >= -1.0'],
    isMasked: ['bool', 't.z > 0.0'],
    /** Whether the light is three's point light, still at the place where its shadow map was drawn. */
    isMaskedPoint: ['bool', 't.x < -1.0 && t.w == 0.0'],
    /** Whether the light is an area light, whose extension record has the layout `areaRecord`. */
    isArea: ['bool', 't.x < -2.5'],
  },
} as const satisfies RecordLayout;

/** Record of options that only the thesis's lights have (`extension`). Colours are linear. */
export const extensionRecord = {
  /** Factor on the light's colour in its diffuse reflection. */
  diffuse: { diffuse: 'rgb' },
  /** Factor on the light's colour in its specular reflection. */
  specular: { specular: 'rgb' },
  /** Ambient light on every surface in range, for any normal. */
  ambient: { ambient: 'rgb' },
  falloff: {
    near: 'x',
    far: 'y',
    /** Factors of an attenuation 1 / (constant + linear (1/m) + quadratic (1/m²)). */
    factors: 'xyz',
    // numbers of attenuationKinds as text, since an expression would add code to pages
    isNearFar: ['bool', 't.w == 1.0'],
    isPolynomial: ['bool', 't.w == 2.0'],
  },
} as const satisfies RecordLayout;

/** Offsets of the texels in a record (floats); written out, so that pages need not load the tables. */
export const LIGHT = { sphere: 0, emission: 4, cone: 8, details: 12 } as const satisfies Offsets<typeof lightRecord>;
export const EXTENSION = {
  diffuse: 0,
  specular: 4,
  ambient: 8,
  falloff: 12,
} as const satisfies Offsets<typeof extensionRecord>;

/**
 * Fourth number of a local light's `emission`: its decay, coded as a number below 0 for a light that is not plain.
 * @param decay - three's `decay`; below 0, light grows with distance, which makes a light not plain
 */
export function emissionDecay(decay: number, isPlain: boolean): number {
  return isPlain ? decay : -64 - Math.max(decay, -63);
}
