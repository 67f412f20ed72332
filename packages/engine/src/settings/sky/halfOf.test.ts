import { DataUtils } from 'three';
import { expect, test } from 'vitest';
import { createRandom } from '../../base/createRandom';
import { halfOf } from './makeSky';

test("is three's half float: of every power of 2, of what lies between, of what is too large", () => {
  const random = createRandom(5);
  const floats = new Float32Array(1);
  const bits = new Uint32Array(floats.buffer);
  const tried = [0, 1, 65_504, 65_503.9];
  for (let power = -149; power < 16; power++)
    tried.push(2 ** power, ...[0, 1, 2].map(() => (1 + random()) * 2 ** power));
  for (const value of tried.filter((each) => each <= 65_504)) {
    floats[0] = value;
    expect(halfOf(bits[0]), String(value)).toBe(DataUtils.toHalfFloat(floats[0]));
  }
  for (const large of [65_536, 1e30, Infinity]) {
    floats[0] = large;
    expect(halfOf(bits[0])).toBe(0x7bff);
  }
});
