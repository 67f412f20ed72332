import { DataUtils, FloatType, HalfFloatType, type WebGLRenderer } from 'three';
import { RectAreaLightTexturesLib } from 'three/addons/lights/RectAreaLightTexturesLib.js';
import { expect, it } from 'vitest';
import { makeTransforms } from './makeTransforms';

const deviceWith = (...names: string[]): WebGLRenderer =>
  ({ extensions: { has: (name: string) => names.includes(name) } }) as unknown as WebGLRenderer;

it('has both tables of three’s, in halves where whole floats are not filtered', () => {
  const whole = makeTransforms(deviceWith('OES_texture_float_linear'));
  const half = makeTransforms(deviceWith());
  expect([whole.type, half.type]).toEqual([FloatType, HalfFloatType]);
  const { LTC_FLOAT_1, LTC_FLOAT_2 } = RectAreaLightTexturesLib.init();
  const tables = [LTC_FLOAT_1, LTC_FLOAT_2].flatMap((table) => [...(table!.image.data as Float32Array)]);
  expect([...whole.image.data!]).toEqual(tables);
  expect(half.image.data).toHaveLength(tables.length);
  let largest = 0;
  half.image.data!.forEach((value: number, i: number) => {
    const off = Math.abs(DataUtils.fromHalfFloat(value) - tables[i]);
    largest = Math.max(largest, off / Math.max(1, Math.abs(tables[i])));
  });
  expect(largest).toBeLessThan(1e-3);
  for (const { image } of [whole, half]) expect([image.width, image.height]).toEqual([64, 128]);
});
