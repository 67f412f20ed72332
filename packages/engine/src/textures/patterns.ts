import { createRandom } from '../base/createRandom';
import { createFractalNoise, createNoise } from './createNoise';

/** A pattern at one point: height, about 0 to 1 (for bumps), and sRGB colour, 0 to 255. */
export interface Texel {
  height: number;
  red: number;
  green: number;
  blue: number;
}

/** Writes the texel at u, v (0 to 1; the pattern repeats) to `out`. */
export type Pattern = (u: number, v: number, out: Texel) => void;

type Rgb = readonly [number, number, number];

const clamp = (value: number, min: number, max: number): number => Math.min(max, Math.max(min, value));
const smooth = (from: number, to: number, value: number): number => {
  const t = clamp((value - from) / (to - from), 0, 1);
  return t * t * (3 - 2 * t);
};

function paint(out: Texel, rgb: Rgb, shade: number, height: number): void {
  out.red = rgb[0] * shade;
  out.green = rgb[1] * shade;
  out.blue = rgb[2] * shade;
  out.height = height;
}

/** Marble: fine grain with a few long veins. */
export function marble(rgb: Rgb, seed: number): Pattern {
  const grain = createFractalNoise(6, 5, seed);
  const stains = createFractalNoise(2, 3, seed + 3);
  const warp = createFractalNoise(3, 4, seed + 7);
  return (u, v, out) => {
    const g = grain(u, v);
    const vein = 1 - smooth(0, 0.035, Math.abs(warp(u, v) - 0.5));
    paint(out, rgb, 0.76 + 0.2 * g + 0.16 * stains(u, v) - 0.1 * vein, 0.3 * g - 0.05 * vein);
  };
}

/** Courses of blocks, every other one shifted by half a block, with joints; `columns` and `rows` fill the texture. */
export function blocks(rgb: Rgb, columns: number, rows: number, seed: number, joint = 0.03): Pattern {
  const grain = createFractalNoise(10, 4, seed);
  const random = createRandom(seed + 1);
  const tints = Float32Array.from({ length: columns * rows }, () => 0.82 + 0.26 * random());
  return (u, v, out) => {
    const row = Math.floor(v * rows) % rows;
    const x = u * columns + (row % 2) * 0.5;
    const column = Math.floor(x) % columns;
    const edgeU = (0.5 - Math.abs((x % 1) - 0.5)) / columns;
    const edgeV = (0.5 - Math.abs(((v * rows) % 1) - 0.5)) / rows;
    const g = grain(u, v);
    const face = smooth(0, joint / rows, Math.min(edgeU, edgeV) - 0.15 * (joint / rows) * g);
    paint(out, rgb, (0.45 + 0.55 * face) * tints[row * columns + column] * (0.8 + 0.35 * g), 0.75 * face + 0.3 * g);
  };
}

/** Floor tiles in two tones like a chess board, with joints. */
export function tiles(light: Rgb, dark: Rgb, count: number, seed: number): Pattern {
  const grain = createFractalNoise(8, 4, seed);
  const random = createRandom(seed + 1);
  const tints = Float32Array.from({ length: count * count }, () => 0.88 + 0.18 * random());
  return (u, v, out) => {
    const [i, j] = [Math.floor(u * count) % count, Math.floor(v * count) % count];
    const edge = Math.min(0.5 - Math.abs(((u * count) % 1) - 0.5), 0.5 - Math.abs(((v * count) % 1) - 0.5));
    const face = smooth(0.006, 0.025, edge);
    const g = grain(u, v);
    const shade = (0.5 + 0.5 * face) * tints[j * count + i] * (0.82 + 0.3 * g);
    paint(out, (i + j) % 2 === 0 ? light : dark, shade, 0.8 * face + 0.12 * g);
  };
}

/** Woven cloth with stripes. */
export function cloth(rgb: Rgb, stripes: number, seed: number): Pattern {
  const grain = createFractalNoise(12, 3, seed);
  return (u, v, out) => {
    const weave = 0.5 + 0.25 * (Math.sin(u * 96 * 2 * Math.PI) + Math.sin(v * 96 * 2 * Math.PI));
    const stripe = Math.abs(((u * stripes) % 1) - 0.5) < 0.06 ? 1.7 : 1;
    paint(out, rgb, stripe * (0.78 + 0.14 * weave + 0.2 * grain(u, v)), 0.35 * weave);
  };
}

/** Planks along u, with grain. */
export function wood(rgb: Rgb, planks: number, seed: number): Pattern {
  const streaks = createFractalNoise(4, 5, seed);
  const random = createRandom(seed + 1);
  const tints = Float32Array.from({ length: planks }, () => 0.78 + 0.36 * random());
  return (u, v, out) => {
    const plank = Math.floor(v * planks) % planks;
    const edge = smooth(0.01, 0.06, 0.5 - Math.abs(((v * planks) % 1) - 0.5));
    const ring = streaks(u + plank * 0.37, v * 7);
    paint(out, rgb, tints[plank] * (0.35 + 0.65 * edge) * (0.75 + 0.45 * ring), 0.7 * edge + 0.35 * ring);
  };
}

/** Grass: blades of many greens. */
export function grass(rgb: Rgb, seed: number): Pattern {
  const patches = createFractalNoise(4, 3, seed);
  const blades = createFractalNoise(48, 3, seed + 3, 0.8);
  return (u, v, out) => {
    const p = patches(u, v);
    const b = blades(u, v);
    paint(out, rgb, 0.55 + 0.35 * p + 0.4 * b, 0.9 * b);
    out.red *= 0.75 + 0.5 * p;
  };
}

/** Plaster: soft stains and a fine grain. */
export function plaster(rgb: Rgb, seed: number): Pattern {
  const stains = createFractalNoise(3, 4, seed);
  const grain = createNoise(128, seed + 5);
  return (u, v, out) => {
    const g = grain(u, v);
    const s = stains(u, v);
    paint(out, rgb, 0.82 + 0.2 * s + 0.05 * g, 0.12 * g + 0.4 * s);
  };
}

/** An evening sky for an environment map: u is the azimuth, v goes from the nadir (0) to the zenith (1). */
export function sky(): Pattern {
  const clouds = createFractalNoise(5, 5, 29);
  return (u, v, out) => {
    const height = v * 2 - 1;
    const glow = Math.exp(-Math.abs(height) * 5) * (0.6 + 0.4 * Math.cos(u * 2 * Math.PI));
    const cloud = height > 0 ? smooth(0.5, 0.75, clouds(u, v)) * 40 : 0;
    const blue = height > 0 ? 70 + 60 * (1 - height) : 38 + 30 * Math.exp(height * 6);
    paint(out, [blue * 0.55 + 150 * glow + cloud, blue * 0.75 + 90 * glow + cloud, blue + 30 * glow + cloud], 1, 0);
  };
}

/** A chess board without joints. */
export function checker(light: Rgb, dark: Rgb, count: number): Pattern {
  return (u, v, out) => paint(out, (Math.floor(u * count) + Math.floor(v * count)) % 2 === 0 ? light : dark, 1, 0);
}
