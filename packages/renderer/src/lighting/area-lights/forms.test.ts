import { describe, expect, it } from 'vitest';
import { findClaims } from '../../authoring/findClaims';
import discForm from './discForm.glsl?raw';
import tubeForm from './tubeForm.glsl?raw';

type Vector = readonly [number, number, number];

const STEPS = 600;

const plus = (a: Vector, b: Vector, scale: number): Vector => [
  a[0] + b[0] * scale,
  a[1] + b[1] * scale,
  a[2] + b[2] * scale,
];
const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: Vector, b: Vector): Vector => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/**
 * Integral of directions over the ellipse's solid angle divided by pi, by samples.
 * @returns length of the integral, and z of its direction
 */
function sampleDisc(centre: Vector, u: Vector, v: Vector): number[] {
  let sum: Vector = [0, 0, 0];
  const normal = cross(u, v);
  for (let i = 0; i < STEPS; i++) {
    for (let k = 0; k < STEPS; k++) {
      const radius = Math.sqrt((i + 0.5) / STEPS);
      const angle = ((k + 0.5) / STEPS) * 2 * Math.PI;
      const at = plus(plus(centre, u, radius * Math.cos(angle)), v, radius * Math.sin(angle));
      const squared = dot(at, at);
      // dω = |n·p| / |p|³ dA, dA = pi |n| / samples
      sum = plus(sum, at, Math.abs(dot(normal, at)) / squared ** 2 / STEPS ** 2);
    }
  }
  const length = Math.sqrt(dot(sum, sum));
  return [length, sum[2] / length];
}

/** Irradiance of z = 0 divided by pi, from a thin tube of radiance 1, by samples. */
function sampleTube(start: Vector, end: Vector, radius: number): number {
  const axis = plus(end, start, -1);
  const length = Math.sqrt(dot(axis, axis));
  let sum = 0;
  const samples = STEPS ** 2;
  for (let i = 0; i < samples; i++) {
    const at = plus(start, axis, (i + 0.5) / samples);
    const squared = dot(at, at);
    const sine = Math.sqrt(Math.max(0, 1 - dot(at, axis) ** 2 / (squared * length ** 2)));
    // from any direction a tube looks as wide as twice its radius
    sum += ((Math.max(0, at[2]) / Math.sqrt(squared)) * 2 * radius * sine * length) / squared / samples;
  }
  return sum / Math.PI;
}

/** The numbers of a claim: the function's arguments, the first `count` of them, and the expected result. */
function numbersOf(claim: { left: string; right: string }, count: number): { given: number[]; wanted: number[] } {
  const numbers = (text: string) =>
    [...text.matchAll(/(?<![\w.])-?\d+\.?\d*(?:e-?\d+)?/g)].map(([digits]) => Number(digits));
  const all = [...numbers(claim.left), ...numbers(claim.right)];
  return { given: all.slice(0, count), wanted: all.slice(count) };
}

const vector = (numbers: number[], i: number): Vector => [numbers[i], numbers[i + 1], numbers[i + 2]];

// e2e/render/claims.spec.ts tests the claims with the shaders
describe('the numbers that the shaders of discs and tubes claim are those of sampling', () => {
  const discs = findClaims(discForm);
  const tubes = findClaims(tubeForm);

  it('are several', () => {
    expect(discs.length).toBeGreaterThan(4);
    expect(tubes.length).toBeGreaterThan(4);
  });

  it.each(discs.map((claim) => [claim.text, claim] as const))('%s', (_, claim) => {
    const { given, wanted } = numbersOf(claim, 9);
    const [form, z] = sampleDisc(vector(given, 0), vector(given, 3), vector(given, 6));
    expect(Math.abs(form - wanted[0])).toBeLessThan(2e-5);
    expect(Math.abs(z - wanted[1])).toBeLessThan(2e-5);
  });

  it.each(tubes.map((claim) => [claim.text, claim] as const))('%s', (_, claim) => {
    const { given, wanted } = numbersOf(claim, 7);
    const form = sampleTube(vector(given, 0), vector(given, 3), given[6]);
    expect(Math.abs(form - wanted[0])).toBeLessThan(2e-5);
  });
});
