import { AmbientLight, type Light, PerspectiveCamera, PointLight, SpotLight } from 'three';
import { describe, expect, it } from 'vitest';
import { FoundLights } from '../lights/FoundLights';
import { POINT, readPoint } from '../lights/plainPoints';
import { VisibleLights } from '../lights/VisibleLights';
import type { LightField } from './LightField';
import { PackedLights } from './PackedLights';

/** Lights as a frame finds them. */
function found(lights: readonly Light[]): FoundLights {
  const found = new FoundLights();
  for (const light of lights) {
    light.updateMatrixWorld();
    found.reserve(1);
    readPoint(light, found.points, found.count * POINT);
    found.add(light);
  }
  return found;
}

function point(x: number, range = 2, intensity = 3): PointLight {
  const light = new PointLight(0xffffff, intensity, range);
  light.position.set(x, 1, -5);
  return light;
}

/** Rows of 128 lights of one of the field's arrays changed since version `seen`. */
function rowsOf(array: LightField['spheres'], seen: number): { rows: number[]; seen: number } {
  const rows: number[] = [];
  const next = array.changes(seen, 100, (first, count) => {
    for (let i = 0; i < count; i++) rows.push(first + i);
  });
  return { rows, seen: next };
}

function camera(x = 0): PerspectiveCamera {
  const camera = new PerspectiveCamera(60, 1, 0.1, 100);
  camera.position.x = x;
  camera.updateMatrixWorld();
  return camera;
}

describe('packed lights', () => {
  it('hold plain point lights with a range, and leave the others', () => {
    const masked = point(1);
    masked.castShadow = true;
    const endless = point(2, 0);
    const risen = new PointLight(0xffffff, 1, 2, -1);
    const bright = point(3, 2, 1e35);
    const others = [new AmbientLight(), new SpotLight(), masked, endless, risen, bright, point(NaN)];
    const plain = [point(0.25), point(0.5, 4, 1)];
    const packed = new PackedLights();
    const field = packed.pack(found([plain[0], ...others, plain[1]]), camera());
    expect(packed.rest).toEqual(others);
    expect(field.count).toBe(2);
    expect([...field.spheres.array.subarray(0, 8)]).toEqual([0.25, 1, -5, 2, 0.5, 1, -5, 4]);
    expect([...field.emissions.array.subarray(0, 8)]).toEqual([3, 3, 3, 2, 1, 1, 1, 2]);
    expect(packed.pack(found([]), camera()).count).toBe(0);
    expect(packed.rest).toEqual([]);
  });

  it('send the rows of lights that moved', () => {
    const lights = Array.from({ length: 600 }, (_, i) => point(i / 100));
    const packed = new PackedLights();
    const field = packed.pack(found(lights), camera());
    const { spheres, emissions } = field;
    const [first, second] = [spheres, emissions].map((array) => rowsOf(array, 0).seen);
    packed.pack(found(lights), camera(50));
    expect([rowsOf(spheres, first).rows, rowsOf(emissions, second).rows]).toEqual([[], []]);
    lights[5].position.y = 9;
    lights[130].position.x = 9;
    lights[599].distance = 3;
    lights[300].color.r = 0.5;
    packed.pack(found(lights), camera());
    expect(rowsOf(spheres, first).rows).toEqual([0, 1, 4]);
    expect(rowsOf(emissions, second).rows).toEqual([2]);
  });

  it('keep their precision far from the origin of the world', () => {
    const packed = new PackedLights();
    const field = packed.pack(found([point(2_000_000.125)]), camera(2_000_000));
    expect(field.spheres.array[0] + field.matrixWorld.elements[12]).toBe(2_000_000.125);
    expect(field.spheres.array[0]).toBe(0.125);
    // near enough: nothing is sent again
    packed.pack(found([point(2_000_000.125)]), camera(2_000_500));
    expect(field.spheres.array[0]).toBe(0.125);
  });

  it('pay from half of the lights in view on, down to 40%', () => {
    const inView = Array.from({ length: 64 }, () => point(0));
    const behind = Array.from({ length: 64 }, (_, i) => {
      const light = point(0);
      light.position.z = i % 8 ? 50 : -5;
      return light;
    });
    const packed = new PackedLights();
    const lights = new VisibleLights();
    const pays = (visible: number, total: number) => packed.pays(Object.assign(lights, { visible, total }));
    expect([pays(0, 0), pays(49, 100), pays(50, 100)]).toEqual([false, false, true]);
    // estimated over 64 frames, one light in 64 each
    for (let i = 0; i < 64; i++) lights.fields[0] = packed.pack(found([...inView, ...behind]), camera());
    expect(packed.share).toBeCloseTo(72 / 128);
    expect(pays(0, 1)).toBe(true);
    for (let i = 0; i < 64; i++) packed.pack(found(behind), camera());
    expect(packed.share).toBeCloseTo(1 / 8);
    expect(pays(1, 1)).toBe(false);
  });
});
