const DEGREES = 180 / Math.PI;

/** Converts radians to degrees, rounded to 9 decimals: π / 3 is 60. */
export const toDegrees = (radians: number): number => Number((radians * DEGREES).toFixed(9));

/** Converts degrees to radians. */
export const toRadians = (degrees: number): number => degrees / DEGREES;
