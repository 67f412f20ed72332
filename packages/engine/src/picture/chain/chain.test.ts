import { Color, DataTexture, Matrix3, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { toneMappings } from '../../settings/toneMappings';
import { makeLookupTable } from './makeLookupTable';
import { toneMapColour } from './toneMapColour';
import { whiteBalance } from './whiteBalance';

const mapped = (name: keyof typeof toneMappings, value: number, exposure = 1): Color => {
  const colour = new Color().setRGB(value, value, value);
  toneMapColour(colour, toneMappings[name], exposure);
  return colour;
};

test('tone mappings keep black, grey and order, end at white, and follow the exposure', () => {
  for (const name of Object.keys(toneMappings) as (keyof typeof toneMappings)[]) {
    if (name === 'none') continue;
    const steps = [0, 0.05, 0.18, 0.5, 1, 4].map((value) => mapped(name, value));
    for (const { r, g, b } of steps) {
      expect(Math.abs(r - g) + Math.abs(g - b), name).toBeLessThan(0.01);
      expect(r, name).toBeGreaterThanOrEqual(0);
      expect(r, name).toBeLessThanOrEqual(1);
    }
    expect(steps[0].r, name).toBeLessThan(0.01);
    for (let i = 1; i < 5; i++) expect(steps[i].r, name).toBeGreaterThan(steps[i - 1].r);
    expect(mapped(name, 0.1, 2).r, name).toBeCloseTo(mapped(name, 0.2).r, 6);
  }
  expect(mapped('none', 3, 2).r).toBe(3);
  // values by the formulas in three's tonemapping_pars_fragment
  expect(mapped('reinhard', 1).r).toBeCloseTo(0.5, 6);
  expect(mapped('linear', 0.3).r).toBeCloseTo(0.3, 6);
  expect(mapped('aces-filmic', 0.6).r).toBeCloseTo(0.6, 1);
});

test('white balance leaves white as it is at 0, and goes warm and cool', () => {
  const of = (temperature: number, tint = 0): Vector3 =>
    new Vector3(1, 1, 1).applyMatrix3(whiteBalance(temperature, tint, new Matrix3()));
  const neutral = of(0);
  for (const value of neutral.toArray()) expect(value).toBeCloseTo(1, 2);
  expect(of(0.5).x).toBeGreaterThan(of(0.5).z);
  expect(of(-0.5).z).toBeGreaterThan(of(-0.5).x);
  expect(of(0, 0.5).y).toBeLessThan(of(0, -0.5).y);
});

/** An image of the slices of an identity table. */
function identity(size: number, columns: number): DataTexture {
  const rows = size / columns;
  const [width, height] = [size * columns, size * rows];
  const data = new Uint8Array(width * height * 4);
  for (let blue = 0; blue < size; blue++)
    for (let green = 0; green < size; green++)
      for (let red = 0; red < size; red++) {
        const x = (blue % columns) * size + red;
        const y = Math.floor(blue / columns) * size + green;
        data.set([red, green, blue, 255], (y * width + x) * 4);
      }
  return new DataTexture(data, width, height);
}

test.each([
  [16, 16],
  [16, 4],
  [16, 1],
])('a table of %i is read from an image of slices, %i in a row', (size, columns) => {
  const table = makeLookupTable(identity(size, columns))!;
  expect([table.image.width, table.image.height, table.image.depth]).toEqual([size, size, size]);
  const { data } = table.image as { data: Uint8Array };
  const wrong = Array.from({ length: size ** 3 }, (_, i) => i).filter((i) => {
    const at = [i % size, Math.floor(i / size) % size, Math.floor(i / size ** 2)];
    return at.some((value, channel) => data[i * 4 + channel] !== value);
  });
  expect(wrong).toEqual([]);
});

test('an image of another form is no table', () => {
  expect(makeLookupTable(new DataTexture(new Uint8Array(4 * 30), 10, 3))).toBeNull();
});
