const RADIANS = Math.PI / 180;

/** Relative air mass at an elevation (rad, above -2°): 1 at the zenith. @see Kasten and Young 1989 */
const airMass = (elevation: number): number =>
  1 / (Math.sin(Math.max(0, elevation)) + 0.50572 * (Math.max(0, elevation) / RADIANS + 6.07995) ** -1.6364);

/** Share of the sun's or the moon's disc that is above the horizon; the disc is half a degree wide. */
const above = (elevation: number): number => Math.min(1, Math.max(0, 0.5 + elevation / (0.53 * RADIANS)));

/**
 * Illuminance (lx) of the sun through a clear sky, on a surface that faces it.
 * @see IES RP-21-84, Recommended Practice for the Calculation of Daylight Availability: 127.5 klx, extinction 0.21
 */
export const sunIlluminance = (elevation: number): number =>
  127500 * Math.exp(-0.21 * airMass(elevation)) * above(elevation);

/** Elevations of the sun (degrees) and the illuminance of a level surface (lx) in twilight, without a moon. */
const twilight: readonly (readonly [number, number])[] = [
  [0, 800],
  [-6, 3.4],
  [-12, 0.0083],
  [-18, 0.001],
];

/**
 * Illuminance (lx) of a level surface by a clear sky, without the sun's own light.
 * @param elevation - of the sun (rad)
 * @see IES RP-21-84 for the day; US Naval Observatory, Illumination, and Schlyter, Radiometry and photometry in astronomy,
 * for twilight
 */
export function skyIlluminance(elevation: number): number {
  if (elevation >= 0) return 800 + 15500 * Math.sqrt(Math.sin(elevation));
  const degrees = elevation / RADIANS;
  for (let i = 1; i < twilight.length; i++) {
    const [low, dark] = twilight[i];
    const [high, light] = twilight[i - 1];
    if (degrees >= low) return light * (dark / light) ** ((high - degrees) / (high - low));
  }
  return 0.001;
}

/**
 * Illuminance (lx) of the moon through a clear sky, on a surface that faces it: 0.27 for a full moon overhead.
 * @param phaseAngle - 0 for full moon, π for new moon
 * @see Krisciunas and Schaefer 1991, A model of the brightness of moonlight: their foot-candles, and 0.172 magnitudes a mass
 */
export function moonIlluminance(elevation: number, phaseAngle: number): number {
  const degrees = Math.abs(phaseAngle) / RADIANS;
  const outside = 10.764 * 10 ** (-0.4 * (3.84 + 0.026 * degrees + 4e-9 * degrees ** 4));
  return outside * 10 ** (-0.4 * 0.172 * airMass(elevation)) * above(elevation);
}

/** Approximate colour temperature (K) of sunlight: 2,000 at the horizon, 5,700 high in the sky. */
export const sunKelvin = (elevation: number): number =>
  2000 + 3700 * (1 - Math.exp(-Math.max(0, elevation) / (12 * RADIANS)));

/** Colour temperature of moonlight (K): sunlight, reddened by the moon's soil. */
export const MOON_KELVIN = 4100;
