/** Light that arrives at given points of a scene, for objects that move. */
export interface BakedProbes {
  /**
   * Floats, 27 per point: nine spherical harmonics of radiance in red, green and blue, in the order of three's
   * SphericalHarmonics3: `lightProbe.sh.fromArray(coefficients, 27 * i)`.
   */
  readonly coefficients: Float32Array;
  /** Share of directions that hit back faces, one per point; above 0.25 the point is inside a solid. */
  readonly backFaces: Float32Array;
}
