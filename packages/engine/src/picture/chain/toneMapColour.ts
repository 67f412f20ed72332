import {
  ACESFilmicToneMapping,
  AgXToneMapping,
  CineonToneMapping,
  type Color,
  LinearToneMapping,
  Matrix3,
  NeutralToneMapping,
  NoToneMapping,
  ReinhardToneMapping,
  type ToneMapping,
  Vector3,
} from 'three';

const clamp = (value: number): number => Math.min(1, Math.max(0, value));

/** A matrix of three columns, as GLSL writes it. */
const columns = (...numbers: number[]): Matrix3 => new Matrix3().fromArray(numbers);

const acesInput = columns(0.59719, 0.076, 0.0284, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
const acesOutput = columns(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
const toRec2020 = columns(0.6274, 0.0691, 0.0164, 0.3293, 0.9195, 0.088, 0.0433, 0.0113, 0.8956);
const fromRec2020 = columns(1.6605, -0.1246, -0.0182, -0.5876, 1.1329, -0.1006, -0.0728, -0.0083, 1.1187);
const agxInset = columns(
  ...[0.856627153315983, 0.137318972929847, 0.11189821299995],
  ...[0.0951212405381588, 0.761241990602591, 0.0767994186031903],
  ...[0.0482516061458583, 0.101439036467562, 0.811302368396859],
);
const agxOutset = columns(
  ...[1.1271005818144368, -0.1413297634984383, -0.14132976349843826],
  ...[-0.11060664309660323, 1.157823702216272, -0.11060664309660294],
  ...[-0.016493938717834573, -0.016493938717834257, 1.2519364065950405],
);
const AGX_LEAST = -12.47393;
const AGX_MOST = 4.026069;

const each = (colour: Vector3, change: (value: number) => number): Vector3 =>
  colour.set(change(colour.x), change(colour.y), change(colour.z));

function sigmoid(x: number): number {
  const x2 = x * x;
  const x4 = x2 * x2;
  return 15.5 * x4 * x2 - 40.14 * x4 * x + 31.96 * x4 - 6.868 * x2 * x + 0.4298 * x2 + 0.1191 * x - 0.00232;
}

function neutral(colour: Vector3): void {
  const start = 0.8 - 0.04;
  const least = Math.min(colour.x, colour.y, colour.z);
  colour.subScalar(least < 0.08 ? least - 6.25 * least * least : 0.04);
  const peak = Math.max(colour.x, colour.y, colour.z);
  if (peak < start) return;
  const rest = 1 - start;
  const newPeak = 1 - (rest * rest) / (peak + rest - start);
  colour.multiplyScalar(newPeak / peak);
  const grey = 1 - 1 / (0.15 * (peak - newPeak) + 1);
  each(colour, (value) => value + (newPeak - value) * grey);
}

const curves: Partial<Record<ToneMapping, (colour: Vector3) => void>> = {
  [LinearToneMapping]: () => {},
  [ReinhardToneMapping]: (colour) => each(colour, (value) => value / (1 + value)),
  [CineonToneMapping]: (colour) =>
    each(colour, (value) => {
      const x = Math.max(0, value - 0.004);
      return ((x * (6.2 * x + 0.5)) / (x * (6.2 * x + 1.7) + 0.06)) ** 2.2;
    }),
  [ACESFilmicToneMapping]: (colour) => {
    colour.divideScalar(0.6).applyMatrix3(acesInput);
    each(colour, (v) => (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.432951) + 0.238081));
    colour.applyMatrix3(acesOutput);
  },
  [AgXToneMapping]: (colour) => {
    colour.applyMatrix3(toRec2020).applyMatrix3(agxInset);
    each(colour, (v) => sigmoid(clamp((Math.log2(Math.max(v, 1e-10)) - AGX_LEAST) / (AGX_MOST - AGX_LEAST))));
    each(colour.applyMatrix3(agxOutset), (v) => Math.max(0, v) ** 2.2).applyMatrix3(fromRec2020);
  },
  [NeutralToneMapping]: neutral,
};

const colour = new Vector3();

/** Tone maps a linear colour as three’s shaders do. */
export function toneMapColour(target: Color, toneMapping: ToneMapping, exposure: number): void {
  const curve = curves[toneMapping];
  if (toneMapping === NoToneMapping || !curve) return;
  colour.set(target.r, target.g, target.b).multiplyScalar(exposure);
  curve(colour);
  target.setRGB(clamp(colour.x), clamp(colour.y), clamp(colour.z));
}
