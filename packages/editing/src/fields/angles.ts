const DEGREES = 180 / Math.PI;

/** Converts radians to degrees, without the digits that the conversion adds: π / 3 is 60. */
export const toDegrees = (radians: number): number => Number((radians * DEGREES).toFixed(9));

/** Radians of an angle in degrees. */
export const toRadians = (degrees: number): number => degrees / DEGREES;
