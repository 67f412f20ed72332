/** Light that arrives at given points of a scene, for objects that move. */
export interface BakedProbes {
  /**
   * Floats, 27 a point: nine coefficients of red, green and blue each, in the order of three's SphericalHarmonics3, of
   * radiance: `lightProbe.sh.fromArray(coefficients, 27 * i)` lights a thing as the point is lit.
   */
  readonly coefficients: Float32Array;
  /** Share of the directions in which a point sees the back of a surface, one a point: above 0.25 it lies within something. */
  readonly backFaces: Float32Array;
}
