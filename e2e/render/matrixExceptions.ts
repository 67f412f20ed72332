/** A case that a technique draws otherwise than stock three, and why. The README lists them too. */
export interface Exception {
  readonly technique: string;
  /** Sheet and name, or the sheet alone with a colon for all of it. */
  readonly cases: readonly string[];
  readonly reason: string;
}

/** All exceptions of the matrix. */
export const matrixExceptions: readonly Exception[] = [
  {
    technique: 'inferred',
    cases: [
      'maps: vertex colours with alpha',
      'maps: transparent',
      'maps: transparent, both sides',
      'maps: transparent, both sides in one pass',
      'maps: additive blending',
      'maps: blended by maximum',
      'maps: premultiplied alpha',
      'geometry: skinned, transparent',
      'order: transparent things by render order',
      'glTF: alpha blend',
      // each has a transparent ball
      'settings: ',
      'settings, 8 bits: ',
    ],
    reason:
      'a transparent layer is lit at one texel of each two by two, and by what is nearest to it in the light buffer',
  },
  {
    technique: 'forward',
    cases: ['maps: alpha test of a map, both sides'],
    reason: 'of two surfaces at exactly one depth in a pixel, the first gets the lights, where three shows the second',
  },
];

/** True if a case is known to be drawn otherwise by a technique. */
export function isException(technique: string, name: string): boolean {
  return matrixExceptions.some(
    (exception) =>
      exception.technique === technique &&
      exception.cases.some((one) => name === one || (one.endsWith(': ') && name.startsWith(one))),
  );
}
