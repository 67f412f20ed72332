/** Seeded cameras and lights for the tests and benchmarks of this folder. */

export interface TestCamera {
  readonly name: string;
  /** 16 elements, column-major. */
  readonly projection: readonly number[];
  readonly near: number;
  readonly far: number;
}

/** @returns numbers from 0 to below 1 (mulberry32) */
export function createRandom(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** Projection matrix of an off-centre perspective; its sides are slopes at depth 1. */
export function perspective(
  left: number,
  right: number,
  bottom: number,
  top: number,
  near: number,
  far: number,
): number[] {
  const z = far === Infinity ? -1 : -(far + near) / (far - near);
  const w = far === Infinity ? -2 * near : (-2 * far * near) / (far - near);
  const a = (right + left) / (right - left);
  const b = (top + bottom) / (top - bottom);
  return [2 / (right - left), 0, 0, 0, 0, 2 / (top - bottom), 0, 0, a, b, z, -1, 0, 0, w, 0];
}

export function orthographic(
  left: number,
  right: number,
  bottom: number,
  top: number,
  near: number,
  far: number,
): number[] {
  const x = 2 / (right - left);
  const y = 2 / (top - bottom);
  const z = -2 / (far - near);
  const translation = [
    -(right + left) / (right - left),
    -(top + bottom) / (top - bottom),
    -(far + near) / (far - near),
  ];
  return [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, ...translation, 1];
}

/** A projection with three's reversed depth, clip z from w at the near plane to 0 at the far one. */
function reversed(projection: readonly number[], near: number, far: number): number[] {
  const m = [...projection];
  const isPerspective = m[11] !== 0;
  m[10] = (isPerspective ? near : 1) / (far - near);
  m[14] = ((isPerspective ? near : 1) * far) / (far - near);
  return m;
}

export const testCameras: readonly TestCamera[] = [
  { name: 'perspective', projection: perspective(-1, 1, -0.56, 0.56, 0.1, 100), near: 0.1, far: 100 },
  { name: 'wide perspective', projection: perspective(-4, 4, -3, 3, 0.01, 50), near: 0.01, far: 50 },
  { name: 'narrow perspective', projection: perspective(-0.05, 0.05, -0.03, 0.03, 1, 300), near: 1, far: 300 },
  { name: 'tiny far plane', projection: perspective(-1, 1, -0.56, 0.56, 0.5, 3), near: 0.5, far: 3 },
  { name: 'huge far plane', projection: perspective(-1, 1, -0.56, 0.56, 1e-3, 1e8), near: 1e-3, far: 1e8 },
  { name: 'no far plane', projection: perspective(-1, 1, -0.56, 0.56, 0.1, Infinity), near: 0.1, far: Infinity },
  { name: 'off-centre perspective', projection: perspective(-0.2, 1.4, -0.9, 0.1, 0.1, 100), near: 0.1, far: 100 },
  { name: 'view wholly off-centre', projection: perspective(0.3, 0.9, 0.2, 0.6, 0.1, 100), near: 0.1, far: 100 },
  { name: 'mirrored perspective', projection: perspective(1, -1, 0.56, -0.4, 0.1, 100), near: 0.1, far: 100 },
  { name: 'orthographic', projection: orthographic(-20, 20, -11, 11, 0.1, 100), near: 0.1, far: 100 },
  { name: 'off-centre orthographic', projection: orthographic(2, 30, -18, -2, -40, 60), near: -40, far: 60 },
  {
    name: 'reversed depth',
    projection: reversed(perspective(-1, 1, -0.56, 0.56, 0.5, 30), 0.5, 30),
    near: 0.5,
    far: 30,
  },
  {
    name: 'orthographic, reversed depth',
    projection: reversed(orthographic(-20, 20, -11, 11, 0.5, 30), 0.5, 30),
    near: 0.5,
    far: 30,
  },
];

/**
 * Spheres [n, 4] around a camera's view: in it, beside it, behind the camera and around it, across the near plane, some of
 * radius 0.
 * @param reach - depth over which they are spread (m)
 * @param radius - from a fifth to twice of it (m)
 */
export function randomSpheres(
  count: number,
  random: () => number,
  { projection: m }: TestCamera,
  reach: number,
  radius: number,
): Float32Array {
  const spheres = new Float32Array(count * 4);
  for (let i = 0; i < count; i++) {
    const atCamera = random() < 0.1;
    const depth = atCamera ? (random() * 2 - 1) * radius : (random() * 1.3 - 0.1) * reach;
    const w = m[11] === 0 ? 1 : Math.abs(depth);
    const u = (random() * 2 - 1) * 1.5;
    const v = (random() * 2 - 1) * 1.5;
    const beside = atCamera ? radius : 0;
    spheres[i * 4] = (u * w + m[8] * depth - m[12]) / m[0] + (random() * 2 - 1) * beside;
    spheres[i * 4 + 1] = (v * w + m[9] * depth - m[13]) / m[5] + (random() * 2 - 1) * beside;
    spheres[i * 4 + 2] = -depth;
    spheres[i * 4 + 3] = random() < 0.03 ? 0 : radius * (0.2 + 1.8 * random() ** 3);
  }
  return spheres;
}

/** Cones [n, 4] for spheres: axis to the light and cosine of the cutoff; a third are spheres (-1). */
export function randomCones(count: number, random: () => number): Float32Array {
  const cones = new Float32Array(count * 4);
  for (let i = 0; i < count; i++) {
    const axis = randomDirection(random);
    cones.set(axis, i * 4);
    cones[i * 4 + 3] = random() < 1 / 3 ? -1 : Math.cos(0.02 + 1.5 * random());
  }
  return cones;
}

export function randomDirection(random: () => number): [number, number, number] {
  const z = random() * 2 - 1;
  const angle = random() * 2 * Math.PI;
  const r = Math.sqrt(1 - z * z);
  return [r * Math.cos(angle), r * Math.sin(angle), z];
}

/** Normalized device coordinates of a point in view space. */
export function project(m: readonly number[], x: number, y: number, z: number): [number, number] {
  const w = m[11] * z + m[15];
  return [(m[0] * x + m[8] * z + m[12]) / w, (m[5] * y + m[9] * z + m[13]) / w];
}
