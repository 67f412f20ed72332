import type { Vector3Tuple } from '@farol/editing/fields';

/** Lowest colour temperature for which a colour can be computed (K). */
export const LOWEST_KELVIN = 1000;
/** Highest colour temperature for which a colour can be computed (K). */
export const HIGHEST_KELVIN = 25000;

/** Luminance of linear sRGB (IEC 61966-2-1). */
export const luminanceOf = ([r, g, b]: Vector3Tuple): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/**
 * Chromaticity of Planck's locus (CIE 1931 x, y), by rational functions of the CIE 1960 u, v.
 * @see Krystek 1985, An algorithm to calculate correlated colour temperature, Color Research & Application 10(1);
 *   https://en.wikipedia.org/wiki/Planckian_locus#Approximation
 */
function planckianChromaticity(kelvin: number): readonly [number, number] {
  const square = kelvin * kelvin;
  const u =
    (0.860117757 + 1.54118254e-4 * kelvin + 1.28641212e-7 * square) /
    (1 + 8.42420235e-4 * kelvin + 7.08145163e-7 * square);
  const v =
    (0.317398726 + 4.22806245e-5 * kelvin + 4.20481691e-8 * square) /
    (1 - 2.89741816e-5 * kelvin + 1.61456053e-7 * square);
  const scale = 2 * u - 8 * v + 4;
  return [(3 * u) / scale, (2 * v) / scale];
}

/**
 * Chromaticity of a CIE daylight illuminant (CIE 1931 x, y).
 * @see CIE 15:2004, Colorimetry, 3.1.3: 4,000 to 25,000 K; http://www.colorpro.com/info/data/daylites.html has the formulas
 */
function daylightChromaticity(kelvin: number): readonly [number, number] {
  const inverse = 1000 / kelvin;
  const x =
    kelvin <= 7000
      ? 0.244063 + inverse * (0.09911 + inverse * (2.9678 - inverse * 4.607))
      : 0.23704 + inverse * (0.24748 + inverse * (1.9018 - inverse * 2.0064));
  return [x, -0.275 + x * (2.87 - 3 * x)];
}

/**
 * CIE 1931 chromaticity of a colour temperature: Planck's locus below 4,000 K, CIE daylight from 4,000 K up.
 * @param kelvin - clamped to 1,000 to 25,000
 */
export function chromaticityOf(kelvin: number): readonly [x: number, y: number] {
  const limited = Math.min(HIGHEST_KELVIN, Math.max(LOWEST_KELVIN, kelvin));
  return limited < 4000 ? planckianChromaticity(limited) : daylightChromaticity(limited);
}

const scaled = ([r, g, b]: Vector3Tuple, factor: number): Vector3Tuple => [r * factor, g * factor, b * factor];

/**
 * Colour of light of a temperature, with luminance 1, so that a light keeps its lumens at any temperature. Colours
 * outside of sRGB's gamut, below 1,900 K, are clipped to its edge.
 * @param kelvin - clamped to 1,000 to 25,000
 * @returns linear sRGB (white D65); channels may be above 1
 */
export function lightOfKelvin(kelvin: number): Vector3Tuple {
  const [x, y] = chromaticityOf(kelvin);
  const X = x / y;
  const Z = (1 - x - y) / y;
  const colour: Vector3Tuple = [
    Math.max(0, 3.2404542 * X - 1.5371385 - 0.4985314 * Z),
    Math.max(0, -0.969266 * X + 1.8760108 + 0.041556 * Z),
    Math.max(0, 0.0556434 * X - 0.2040259 + 1.0572252 * Z),
  ];
  return scaled(colour, 1 / luminanceOf(colour));
}

/**
 * Colour of a temperature, with the largest channel at 1, as in tables of colours.
 * @param kelvin - clamped to 1,000 to 25,000
 * @returns linear sRGB (white D65)
 */
export function colourOfKelvin(kelvin: number): Vector3Tuple {
  const colour = lightOfKelvin(kelvin);
  return scaled(colour, 1 / Math.max(...colour));
}
