import { TEXELS_PER_RECORD } from '../../lights/lightRecord';
import { type RecordLayout, texelOffsets } from '../../lights/recordLayout';

/** Ways in which shaders sample a light's shadow map. */
export const shadowLookups = { none: 0, basic: 1, pcf: 2, cubeBasic: 3, cubePcf: 4, variance: 5, soft: 6 } as const;

/** Kinds of cookie, an image that a light projects. `profile`: a photometric profile, whose cookie is `profileCookie`. */
export const cookieShapes = { none: 0, map: 1, cube: 2, profile: 3 } as const;

/**
 * First bit of each part of the whole number in the mask record's texel `place`; the bits below `lookup` are the width
 * of a face.
 */
export const PLACE_BITS = { lookup: 15, cookie: 18, extended: 20, border: 21 } as const;

/**
 * A mask in the light table: limits a light by its shadow map, cookie, profile and layers. Its texels lie in three records.
 * Offsets for TypeScript (`MASK`) and getters for GLSL (microshader `maskRecord`) are made from this table. For every light that
 * reaches it, a pixel reads `place`, `filtering` and the columns of the matrix that it needs; other texels rarely.
 */
export const maskRecord = {
  /** Columns of the matrix from view space to the map (0 to 1, depth 0 to 1); for a cube only `position`. */
  columnX: {
    /** Position of a point light when its map was drawn (view space, m). */
    position: 'xyz',
  },
  columnY: {},
  columnZ: {},
  columnW: {},
  place: {
    /** Corner of the shadow map's region in the atlas (texels). */
    corner: 'xy',
    /** Width of the shadow map, or of a face of its cube (texels). */
    width: ['int', `int(t.z) & ${(1 << PLACE_BITS.lookup) - 1}`],
    /** Way in which the shadow map is sampled, one of `shadowLookups`. */
    lookup: ['int', `int(t.z) >> ${PLACE_BITS.lookup} & 7`],
    /** Kind of the light's cookie, one of `cookieShapes`. */
    cookieShape: ['int', `int(t.z) >> ${PLACE_BITS.cookie} & 3`],
    /** Whether `extent` is used; for a cube, whether `position` is, since the light has moved since its map was drawn. */
    isExtended: ['bool', `(int(t.z) & ${1 << PLACE_BITS.extended}) != 0`],
    /** Width of the border round a cube's face (texels). */
    border: ['int', `1 << (int(t.z) >> ${PLACE_BITS.border})`],
    /** Offset along the surface's normal at which the map is sampled (m). */
    normalBias: 'w',
  },
  /**
   * For a map: x bias, signed as the depth buffer; yz filter radius as share of width and height; for a variance shadow map x is
   * 1 where depth grows with distance, -1 where it is reversed. For a cube: xy a and b of depth = a + b / distance along an
   * axis; z filter radius as share of a face, or half an area light's size (m, `soft`). w: the shadow's intensity.
   */
  filtering: { intensity: 'w' },
  /** Size of the shadow map, unless it is a cube; sampling of the light's cookie. */
  extent: {
    /** Height of the shadow map (texels), and number of its cascades. */
    heightAndCascades: 'xy',
    /** Whether `ShadowBounds` has depth bounds for the map. */
    hasBounds: ['bool', 't.z != 0.0'],
    /** Sampling of the cookie's copy, see `imageFilter`; if negative, the texture itself, by sampler -1 - cookieFilter. */
    cookieFilter: ['int', 'int(t.w)'],
  },
  /** Region of the photometric profile in the atlas: corner, size (texels). */
  profile: {},
  /**
   * Region of the cookie: corner, size of its first level, or of a face of it, without borders (texels). With three
   * cascades instead: transform to the third, as `firstFit`.
   */
  cookie: {},
  layers: {
    /** Layers whose objects the light reaches: low 16 bits, high 16 bits; 0 for all. */
    layers: 'xy',
    /**
     * Change of the view ray from a pixel to the next, across and up, at distance 1; negative: of an orthographic ray's origin
     * (m).
     */
    pixelSpan: 'zw',
  },
  /**
   * Transform of coordinates in the whole shadow camera's map to the first cascade's: scale, shift of x; scale, shift of y.
   * For a light with a photometric profile: directions of horizontal angle 0 and of vertical angle 0 (view space, unit
   * length).
   */
  firstFit: {
    profileAcross: 'xyz',
    /** Kind of the cookie of a light that also has a photometric profile, one of `cookieShapes` without `profile`. */
    profileCookie: ['int', 'int(t.w)'],
  },
  secondFit: { profileDown: 'xyz' },
} as const satisfies RecordLayout;

/** Offset (floats) of each texel of a mask from the mask's first float. */
export const MASK = texelOffsets(maskRecord);

export const RECORDS_PER_MASK = Object.keys(maskRecord).length / TEXELS_PER_RECORD;

/** Greatest number of cascades of a directional light, besides the map of the light's whole shadow camera. */
export const MOST_CASCADES = 3;
export const FITS = [MASK.firstFit, MASK.secondFit, MASK.cookie] as const;
