import type { Camera, Matrix4 } from 'three';
import type { LightField } from './LightField';
import { fieldCount } from '../lights/lightData';
import { sphereCoverage } from '../lights/spheres';

/** Number of lights sampled from a field, and of frames for which the result is kept. */
const SAMPLES = 64;
const LASTS = 8;
/** Initial range of depths, as base-2 logarithms: 1 to 64 m. */
const LEAST = 0;
const EXTENT = 6;
/** Assumed share of the picture that a light covers, for fields whose textures only the GPU has. */
const COVERAGE = 0.002;

interface Told {
  age: number;
  coverage: number;
  near: number;
  far: number;
}

/**
 * Depth range and screen coverage of a frame's fields, estimated from a few of their lights. Only speed depends on
 * them.
 */
export class FieldDepths {
  /** Depth at which the slices begin (m), or its base-2 logarithm if `isLogarithmic`. */
  nearest = LEAST;
  extent = EXTENT;
  isLogarithmic = true;
  /** Mean number of lights over a pixel: sum of the shares of the picture that they cover. */
  coverage = 0;
  private readonly known = new WeakMap<LightField, Told>();
  private near = Infinity;
  private far = -Infinity;

  begin(camera: Camera): void {
    this.coverage = 0;
    this.near = Infinity;
    this.far = -Infinity;
    this.isLogarithmic = camera.projectionMatrix.elements[11] !== 0;
  }

  add(field: LightField, camera: Camera): void {
    let told = this.known.get(field);
    if (told === undefined) this.known.set(field, (told = { age: 0, coverage: 0, near: Infinity, far: -Infinity }));
    if (told.age++ % LASTS === 0) this.measure(field, camera, told);
    this.coverage += told.coverage;
    this.near = Math.min(this.near, told.near);
    this.far = Math.max(this.far, told.far);
  }

  end(): void {
    this.nearest = this.near < this.far ? this.near : this.isLogarithmic ? LEAST : 0;
    this.extent = this.near < this.far ? this.far - this.near : this.isLogarithmic ? EXTENT : 100;
  }

  private measure(field: LightField, { projectionMatrix, matrixWorldInverse }: Camera, told: Told): void {
    const count = fieldCount(field);
    told.near = Infinity;
    told.far = -Infinity;
    told.coverage = 0;
    if (count === 0) return;
    if (field.textures !== null) {
      told.coverage = count * COVERAGE;
      return;
    }
    const { array } = field.spheres;
    const step = Math.max(1, Math.floor(count / SAMPLES));
    let seen = 0;
    for (let i = 0; i < count; i += step) {
      seen++;
      const at = i * 4;
      const range = array[at + 3];
      const depth = -viewZ(matrixWorldInverse, field.matrixWorld, array[at], array[at + 1], array[at + 2]);
      if (!Number.isFinite(depth + range) || (this.isLogarithmic && depth + range <= 0)) continue;
      told.coverage += sphereCoverage(depth, Math.max(0, range), projectionMatrix.elements);
      const place = this.isLogarithmic ? Math.log2(Math.max(depth, 1e-3)) : depth;
      if (place < told.near) told.near = place;
      if (place > told.far) told.far = place;
    }
    told.coverage *= count / seen;
  }
}

function viewZ({ elements: v }: Matrix4, { elements: m }: Matrix4, x: number, y: number, z: number): number {
  const wx = m[0] * x + m[4] * y + m[8] * z + m[12];
  const wy = m[1] * x + m[5] * y + m[9] * z + m[13];
  const wz = m[2] * x + m[6] * y + m[10] * z + m[14];
  return v[2] * wx + v[6] * wy + v[10] * wz + v[14];
}
