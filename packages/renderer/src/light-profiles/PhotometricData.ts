/** Editions of the LM-63 standard. */
export type IESVersion = 'LM-63-1986' | 'LM-63-1991' | 'LM-63-1995' | 'LM-63-2002' | 'LM-63-2019';

/** Change of a luminaire's light when its lamps are tilted (the TILT table of an IES file). */
export interface LampTilt {
  /** Lamps' orientation as measured: 1 vertical, 2 horizontal and parallel to the axis of tilt, 3 horizontal across it. */
  readonly geometry: number;
  /** Angles from the measured position (degrees), ascending. */
  readonly angles: Float64Array;
  /** Factor on the candela values at each tilt angle. */
  readonly factors: Float64Array;
}

/** Contents of a photometric file of the LM-63 standard, in SI units, except for angles in degrees as in the file. */
export interface PhotometricData {
  readonly version: IESVersion;
  /** Texts by keyword, such as MANUFAC and LUMINAIRE, upper case; LM-63-1986 has no keywords: LABEL. */
  readonly keywords: ReadonlyMap<string, string>;
  /**
   * The goniometer's axes. C: planes around the vertical axis. B: planes around a horizontal axis. A: planes around the vertical
   * axis, for luminaires that aim horizontally.
   */
  readonly type: 'A' | 'B' | 'C';
  readonly lamps: number;
  /** Luminous flux of each lamp (lm); -1 where the luminaire was measured as a whole. */
  readonly lumensPerLamp: number;
  /** Width of the luminous opening (m), 0 for a point; negative for round shapes, as in the standard. */
  readonly width: number;
  readonly length: number;
  readonly height: number;
  readonly inputWatts: number;
  readonly tilt: LampTilt | null;
  /** Vertical angles (degrees), ascending. */
  readonly verticalAngles: Float64Array;
  /** Horizontal angles (degrees), ascending. */
  readonly horizontalAngles: Float64Array;
  /** Candelas with factors applied: for each horizontal angle, all vertical angles. */
  readonly candelas: Float64Array;
}
