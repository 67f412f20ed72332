import { Matrix3 } from 'three';

/** D65 white as cone responses (LMS, CAT02). */
const D65 = [0.949237, 1.03542, 1.08728] as const;
const toCones = new Matrix3().set(
  ...([0.390405, 0.549941, 0.00892632, 0.0708416, 0.963172, 0.00135775, 0.0231082, 0.128021, 0.936245] as const),
);
const fromCones = new Matrix3().set(
  ...([2.85847, -1.62879, -0.024891, -0.210182, 1.1582, 0.000324281, -0.041812, -0.118169, 1.06867] as const),
);
const scale = new Matrix3();

/**
 * Matrix that makes linear colours warmer or cooler, as under another illuminant: von Kries in cone responses, along
 * the daylight locus.
 * @param temperature - from -1, cool, to 1, warm
 * @param tint - from -1, green, to 1, magenta
 * @param matrix - receives the result
 * @see Fairchild 2013, Color Appearance Models, 3rd edition, chapter 9
 */
export function whiteBalance(temperature: number, tint: number, matrix: Matrix3): Matrix3 {
  const warm = (temperature * 100) / 65;
  const x = 0.31271 - warm * (warm < 0 ? 0.1 : 0.05);
  const y = 2.87 * x - 3 * x * x - 0.27509507 + ((tint * 100) / 65) * 0.05;
  const [X, Y, Z] = [x / y, 1, (1 - x - y) / y];
  scale.set(
    ...([D65[0] / (0.7328 * X + 0.4296 * Y - 0.1624 * Z), 0, 0] as const),
    ...([0, D65[1] / (-0.7036 * X + 1.6975 * Y + 0.0061 * Z), 0] as const),
    ...([0, 0, D65[2] / (0.003 * X + 0.0136 * Y + 0.9834 * Z)] as const),
  );
  return matrix.multiplyMatrices(fromCones, scale).multiply(toCones);
}
