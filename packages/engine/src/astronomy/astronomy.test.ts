import { describe, expect, test } from 'vitest';
import { moonIlluminance, skyIlluminance, sunIlluminance, sunKelvin } from './daylight';
import { julianDay, moonPlace, sunPlace } from './sunAndMoon';

const RADIANS = Math.PI / 180;

/** Angle between two directions of azimuth and elevation (degrees). */
function apart([a, e]: readonly number[], place: { azimuth: number; elevation: number }): number {
  const cosine =
    Math.sin(e * RADIANS) * Math.sin(place.elevation) +
    Math.cos(e * RADIANS) * Math.cos(place.elevation) * Math.cos(place.azimuth - a * RADIANS);
  return Math.acos(Math.min(1, cosine)) / RADIANS;
}

test('Julian days of Meeus 1998, 7', () => {
  expect(julianDay(2000, 1, 1, 12)).toBe(2451545);
  expect(julianDay(1957, 10, 4, 19.44)).toBeCloseTo(2436116.31, 6);
  expect(julianDay(1987, 6, 19, 12)).toBe(2446966);
});

describe('sun and moon are where almanacs have them', () => {
  test('the example of NREL’s Solar Position Algorithm: zenith 50.11162°, azimuth 194.34024°', () => {
    const place = sunPlace(julianDay(2003, 10, 17, 19 + 30.5 / 60), {
      latitude: 39.742476 * RADIANS,
      longitude: -105.1786 * RADIANS,
    });
    expect(apart([194.34024, 90 - 50.11162], place)).toBeLessThan(0.02);
  });

  // azimuth and apparent elevation of sun and moon, and the moon's lit part, by VSOP87 and a full lunar theory (PyEphem
  // 4)
  test.each([
    ['London', 51.5, -0.13, [2024, 6, 20, 12], [178.915, 61.942], [39.965, -60.667], 0.9712],
    ['Quito', -0.18, -78.47, [2024, 3, 20, 15.5], [89.221, 62.218], [38.301, -61.679], 0.8178],
    ['Sydney', -33.87, 151.21, [2023, 12, 21, 20], [108.969, 14.187], [226.887, -59.091], 0.7234],
    ['Reykjavik', 64.15, -21.94, [2025, 1, 5, 13 + 1 / 6], [174.615, 3.403], [103.301, 3.744], 0.3395],
    ['Tokyo', 35.68, 139.69, [2030, 9, 1, 4], [217.972, 57.243], [158.487, 39.694], 0.1233],
    ['Singapore', 1.35, 103.82, [1999, 8, 11, 0.5], [74.061, 19.657], [71.751, 24.13], 0.0026],
    ['Tromsø', 69.65, 18.96, [2024, 6, 21, 22], [349.401, 3.66], [171.359, -9.176], 0.998],
    ['Mexico', 19.43, -99.13, [2026, 11, 27, 18], [171.399, 48.934], [308.071, -22.289], 0.8605],
  ] as const)('%s', (_, latitude, longitude, [year, month, date, hour], sun, moon, lit) => {
    const day = julianDay(year, month, date, hour);
    const place = { latitude: latitude * RADIANS, longitude: longitude * RADIANS };
    expect(apart(sun, sunPlace(day, place))).toBeLessThan(0.03);
    const seen = moonPlace(day, place);
    expect(apart(moon, seen)).toBeLessThan(0.5);
    expect(Math.abs(seen.lit - lit)).toBeLessThan(0.005);
  });
});

describe('light of the sky', () => {
  test('sun overhead 103 klx, low and red at the horizon, gone below', () => {
    expect(sunIlluminance(Math.PI / 2) / 103350).toBeCloseTo(1, 2);
    expect(sunIlluminance(0)).toBeLessThan(100);
    expect(sunIlluminance(-0.02)).toBe(0);
    expect([sunKelvin(0), Math.round(sunKelvin(1.5))]).toEqual([2000, expect.closeTo(5700, -2)]);
  });

  test('clear sky 16.3 klx at noon, 3.4 lx at the end of civil twilight, starlight at night', () => {
    expect(skyIlluminance(Math.PI / 2)).toBe(16300);
    expect(skyIlluminance(-6 * RADIANS)).toBeCloseTo(3.4);
    expect(skyIlluminance(-12 * RADIANS)).toBeCloseTo(0.0083);
    expect(skyIlluminance(-1)).toBe(0.001);
    let before = Infinity;
    for (let degrees = 90; degrees > -20; degrees -= 0.5) {
      const light = skyIlluminance(degrees * RADIANS);
      expect(light).toBeLessThanOrEqual(before);
      before = light;
    }
  });

  // Kyba et al. 2017, How bright is moonlight?: 0.05 to 0.3 lx at full moon; a half moon gives a tenth of it
  test('moon: 0.27 lx full and overhead, a tenth of it half', () => {
    const full = moonIlluminance(Math.PI / 2, 0);
    expect(full).toBeGreaterThan(0.25);
    expect(full).toBeLessThan(0.3);
    expect(moonIlluminance(Math.PI / 2, Math.PI / 2) / full).toBeCloseTo(0.09, 1);
    expect(moonIlluminance(-0.02, 0)).toBe(0);
  });
});
