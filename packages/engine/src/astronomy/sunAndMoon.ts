/** A place in the sky, seen from the ground (rad). */
export interface SkyPlace {
  /** Angle from north, increasing towards east, 0 to 2π. */
  readonly azimuth: number;
  /** Angle above the horizon, raised by atmospheric refraction. */
  readonly elevation: number;
}

export interface MoonPlace extends SkyPlace {
  /** Angle at the moon between sun and earth (rad): 0 for full moon, π for new moon. */
  readonly phaseAngle: number;
  /** Part of the disc that is lit, 0 to 1. */
  readonly lit: number;
}

const RADIANS = Math.PI / 180;
const sin = (degrees: number): number => Math.sin(degrees * RADIANS);
const cos = (degrees: number): number => Math.cos(degrees * RADIANS);

/**
 * Julian day of a date of the Gregorian calendar. Days and hours out of range carry over into other months and days.
 * @param month - 1 to 12
 * @param hour - universal time, with fractions
 */
export const julianDay = (year: number, month: number, day: number, hour: number): number =>
  Date.UTC(year, month - 1, day) / 86400000 + hour / 24 + 2440587.5;

/** Julian centuries since the year 2000. */
const centuriesOf = (day: number): number => (day - 2451545) / 36525;

/** Obliquity of the ecliptic (degrees). @see Meeus 1998, Astronomical Algorithms, 22 and 25 */
const obliquity = (t: number): number => 23.439291 - 0.0130042 * t + 0.00256 * cos(125.04 - 1934.136 * t);

/** Apparent longitude of the sun (degrees), to 0.01°. @see Meeus 1998, 25 */
function sunLongitude(t: number): number {
  const mean = 280.46646 + t * (36000.76983 + t * 0.0003032);
  const anomaly = 357.52911 + t * (35999.05029 - t * 0.0001537);
  const centre =
    (1.914602 - t * (0.004817 + t * 0.000014)) * sin(anomaly) +
    (0.019993 - 0.000101 * t) * sin(2 * anomaly) +
    0.000289 * sin(3 * anomaly);
  return mean + centre - 0.00569 - 0.00478 * sin(125.04 - 1934.136 * t);
}

/** Term of a series: amplitude, phase and rate of a sine (degrees, degrees, degrees per century). */
type Term = readonly [amplitude: number, phase: number, rate: number];

const sumOf = (terms: readonly Term[], t: number): number =>
  terms.reduce((sum, [amplitude, phase, rate]) => sum + amplitude * sin(phase + rate * t), 0);

/** Longitude, latitude and parallax of the moon, to 0.3°. @see The Astronomical Almanac, D22, low-precision formulae */
const moonLongitude: readonly Term[] = [
  [6.29, 135, 477198.87],
  [-1.27, 259.3, -413335.36],
  [0.66, 235.7, 890534.22],
  [0.21, 269.9, 954397.74],
  [-0.19, 357.5, 35999.05],
  [-0.11, 186.5, 966404.03],
];
const moonLatitude: readonly Term[] = [
  [5.13, 93.3, 483202.02],
  [0.28, 228.2, 960400.89],
  [-0.28, 318.3, 6003.15],
  [-0.17, 217.6, -407332.21],
];
const moonParallax: readonly Term[] = [
  [0.0518, 225, 477198.87],
  [0.0095, 349.3, -413335.36],
  [0.0078, 325.7, 890534.22],
  [0.0028, 359.9, 954397.74],
];

/** Refraction at a true elevation (degrees): Saemundsson's formula. @see Meeus 1998, 16 */
const refraction = (elevation: number): number =>
  elevation < -1 ? 0 : 1.02 / 60 / Math.tan((elevation + 10.3 / (elevation + 5.11)) * RADIANS);

/** Converts ecliptic coordinates to a place in the sky. @param parallax - horizontal (degrees); 0 for a distant body */
function placeOf(
  { longitude, latitude, parallax }: { longitude: number; latitude: number; parallax: number },
  day: number,
  place: { readonly latitude: number; readonly longitude: number },
): SkyPlace {
  const t = centuriesOf(day);
  const tilt = obliquity(t);
  const ascension =
    Math.atan2(sin(longitude) * cos(tilt) * cos(latitude) - sin(latitude) * sin(tilt), cos(longitude) * cos(latitude)) /
    RADIANS;
  const declination = Math.asin(sin(latitude) * cos(tilt) + cos(latitude) * sin(tilt) * sin(longitude)) / RADIANS;
  const sidereal = 280.46061837 + 360.98564736629 * (day - 2451545) + 0.000387933 * t * t;
  const hour = sidereal + place.longitude / RADIANS - ascension;
  const north = place.latitude / RADIANS;
  const up = sin(north) * sin(declination) + cos(north) * cos(declination) * cos(hour);
  const east = -cos(declination) * sin(hour);
  const toNorth = sin(declination) * cos(north) - cos(declination) * cos(hour) * sin(north);
  // a near body appears lower from the surface than from the centre of the earth
  const elevation = Math.atan2(up - sin(parallax), Math.hypot(east, toNorth));
  return {
    azimuth: (Math.atan2(east, toNorth) + 2 * Math.PI) % (2 * Math.PI),
    elevation: elevation + refraction(elevation / RADIANS) * RADIANS,
  };
}

/** Latitude (north) and longitude (east) of a place on earth (rad). */
export interface EarthPlace {
  readonly latitude: number;
  readonly longitude: number;
}

/** The sun at a Julian day (universal time), to 0.02°. */
export function sunPlace(day: number, place: EarthPlace): SkyPlace {
  return placeOf({ longitude: sunLongitude(centuriesOf(day)), latitude: 0, parallax: 0.0024 }, day, place);
}

/** The moon at a Julian day (universal time), to 0.4°. */
export function moonPlace(day: number, place: EarthPlace): MoonPlace {
  const t = centuriesOf(day);
  const longitude = 218.32 + 481267.881 * t + sumOf(moonLongitude, t);
  const latitude = sumOf(moonLatitude, t);
  const elongation = cos(latitude) * cos(longitude - sunLongitude(t));
  return {
    ...placeOf({ longitude, latitude, parallax: 0.9508 + sumOf(moonParallax, t) }, day, place),
    phaseAngle: Math.PI - Math.acos(elongation),
    lit: (1 - elongation) / 2,
  };
}
