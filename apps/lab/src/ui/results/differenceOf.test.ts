import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { differenceOf } from './differenceOf';

class Picture {
  data: Uint8ClampedArray;
  constructor(
    readonly width: number,
    readonly height: number,
    values: readonly number[] = [],
  ) {
    this.data = new Uint8ClampedArray(width * height * 4);
    this.data.set(values);
  }
}
const picture = (width: number, height: number, values: readonly number[]): ImageData =>
  new Picture(width, height, values) as unknown as ImageData;

beforeEach(() => vi.stubGlobal('ImageData', Picture));
afterEach(() => vi.unstubAllGlobals());

test('what is darker and what is brighter shows alike, alpha is left out', () => {
  const difference = differenceOf(
    picture(2, 1, [10, 20, 30, 255, 0, 0, 0, 255]),
    picture(2, 1, [12, 10, 30, 9, 200, 0, 1, 255]),
  );
  expect([...difference!.data]).toEqual([16, 80, 0, 255, 255, 0, 8, 255]);
});

test('pictures of two sizes are not compared', () => {
  expect(differenceOf(picture(2, 1, []), picture(1, 2, []))).toBeNull();
});
