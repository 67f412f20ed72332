import type { RecordLayout } from './recordLayout';

type Offsets<Layout extends RecordLayout> = { readonly [texel in keyof Layout]: number };

/**
 * The light table: a texture of RGBA32F texels, `TEXELS_PER_RECORD` a record, `RECORDS_PER_ROW` records a row. A light
 * is one record; what few lights need lies in records of their own, behind all lights: a mask (`masks/maskRecord.ts`:
 * the light's shadow map and cookie) and an extension (what only a light of the thesis or an area light has).
 *
 * The offsets for TypeScript below, and lightRecord.glsl with its getters, are made from the two tables:
 * recordGetters.test.ts.
 */
export const TEXELS_PER_RECORD = 4;
export const RECORDS_PER_ROW = 256;
export const FLOATS_PER_RECORD = TEXELS_PER_RECORD * 4;

/** Stands for a light's index, for a record that lights nothing. */
export const NO_LIGHT = 0xffffffff;

/** In place of a point light's cone: the cosine of its cutoff, and that of its penumbra, which no spot light has. */
export const POINT_CUTOFF = -3;
export const POINT_PENUMBRA = -2;
/** Penumbra that marks an area light, as POINT_PENUMBRA does a point light. */
export const AREA_PENUMBRA = -3;
/** Spot exponent in the record of a light whose cone has three's penumbra instead. */
export const NO_EXPONENT = -1;
/** Fraction added to record indices in `details`, of a point light that has left its shadow map's place; shaders drop it. */
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
     * Local light: whether it is a point light as three has it, without a mask; its cone and details are not written.
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
    /** Whether the light is an area light, whose extension is its own. */
    isArea: ['bool', 't.x < -2.5'],
  },
} as const satisfies RecordLayout;

/** Record of the settings that only a light of the thesis has (`extension`). Colours are linear. */
export const extensionRecord = {
  /** Factor on the light's colour in its diffuse reflection. */
  diffuse: { diffuse: 'rgb' },
  /** Factor on the light's colour in its specular reflection. */
  specular: { specular: 'rgb' },
  /** Ambient light, given to every surface in reach, whatever its normal. */
  ambient: { ambient: 'rgb' },
  falloff: {
    near: 'x',
    far: 'y',
    /** Factors of an attenuation 1 / (constant + linear (1/m) + quadratic (1/m²)). */
    factors: 'xyz',
    // kinds of attenuationKinds as text: an expression would be code that pages load
    isNearFar: ['bool', 't.w == 1.0'],
    isPolynomial: ['bool', 't.w == 2.0'],
  },
} as const satisfies RecordLayout;

/** Offsets of the texels in a record (floats); written out here, so that a page need not load the tables. */
export const LIGHT = { sphere: 0, emission: 4, cone: 8, details: 12 } as const satisfies Offsets<typeof lightRecord>;
export const EXTENSION = {
  diffuse: 0,
  specular: 4,
  ambient: 8,
  falloff: 12,
} as const satisfies Offsets<typeof extensionRecord>;

/**
 * Fourth number of a local light's `emission`: its decay, coded as below 0 for a light that is not plain.
 * @param decay - as three has it; below 0 light grows with distance, which no plain light does
 */
export function emissionDecay(decay: number, isPlain: boolean): number {
  return isPlain ? decay : -64 - Math.max(decay, -63);
}
