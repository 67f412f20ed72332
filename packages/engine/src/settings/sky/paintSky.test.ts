import { expect, test } from 'vitest';
import { skyPresets } from '../pictureFields';
import { makeGradientSky, makePresetSky } from './makeSky';
import { paintSky } from './paintSky';
import { skyLooks } from './skyLooks';

const WIDTH = 256;
const HEIGHT = 128;

/** Mean luminance of the rows between two heights: 0 is the nadir, 1 the zenith. */
function meanOf(pixels: Float32Array, from: number, to: number): number {
  const first = Math.floor(from * HEIGHT) * WIDTH * 3;
  const last = Math.ceil(to * HEIGHT) * WIDTH * 3;
  let sum = 0;
  for (let at = first; at < last; at += 3)
    sum += 0.2126 * pixels[at] + 0.7152 * pixels[at + 1] + 0.0722 * pixels[at + 2];
  return sum / ((last - first) / 3);
}

test.each(skyPresets)('%s is light that can be drawn, the same each time, and whole all round', (preset) => {
  const pixels = paintSky(skyLooks[preset], WIDTH, HEIGHT);
  expect(pixels.every((value) => value >= 0 && value < 100)).toBe(true);
  const again = paintSky(skyLooks[preset], WIDTH, HEIGHT);
  expect(again.every((value, i) => value === pixels[i])).toBe(true);
  // neighbours across the seam differ no more than others, apart from those at the sun
  let [atSeam, elsewhere] = [0, 0];
  for (let row = 0; row < HEIGHT; row++) {
    for (let column = 0; column < WIDTH; column++) {
      const here = pixels[(row * WIDTH + column) * 3];
      const step = Math.abs(here - pixels[(row * WIDTH + ((column + 1) % WIDTH)) * 3]);
      if (column === WIDTH - 1) atSeam = Math.max(atSeam, step);
      else if (here < 1.5 || preset === 'studio') elsewhere = Math.max(elsewhere, step);
    }
  }
  expect(atSeam).toBeLessThanOrEqual(elsewhere);
});

test('days are bright, nights dark, and the sky is brighter than the ground', () => {
  const light = (preset: (typeof skyPresets)[number]): number =>
    meanOf(paintSky(skyLooks[preset], WIDTH, HEIGHT), 0.5, 1);
  expect(light('clear-day')).toBeGreaterThan(0.3);
  expect(light('overcast')).toBeGreaterThan(0.3);
  expect(light('sunset')).toBeLessThan(light('overcast'));
  expect(light('night')).toBeLessThan(0.05);
  const day = paintSky(skyLooks['clear-day'], WIDTH, HEIGHT);
  expect(meanOf(day, 0, 0.4)).toBeLessThan(meanOf(day, 0.6, 1));
});

test.each([
  ['by the preset', null],
  ['by angles', { azimuth: 1.2, elevation: 0.9 }],
])('the sun is where it is said to be: %s', (_, sun) => {
  const disc = sun ?? skyLooks.sunset.disc;
  const { texture } = makePresetSky('sunset', sun);
  const { width, height, data } = texture.image as { width: number; height: number; data: Uint16Array };
  const column = Math.floor((disc!.azimuth / (2 * Math.PI) + 0.5) * width);
  const row = Math.floor((disc!.elevation / Math.PI + 0.5) * height);
  let brightest = 0;
  for (let at = 0; at < data.length; at += 4) if (data[at] > data[brightest]) brightest = at;
  const pixel = brightest / 4;
  expect(Math.abs((pixel % width) - column)).toBeLessThan(6);
  expect(Math.abs(Math.floor(pixel / width) - row)).toBeLessThan(6);
});

test('a sky is painted again only for another place of its sun, and without a sun there is none to place', () => {
  const sun = { azimuth: 0.3, elevation: 0.5 };
  const dataOf = (...args: Parameters<typeof makePresetSky>): unknown => makePresetSky(...args).texture.image.data;
  expect(dataOf('clear-day', sun)).toBe(dataOf('clear-day', { ...sun }));
  expect(dataOf('clear-day')).toBe(dataOf('clear-day', null));
  expect(dataOf('clear-day')).not.toBe(dataOf('clear-day', sun));
  expect(dataOf('overcast', sun)).toBe(dataOf('overcast'));
});

test('a gradient goes from the ground by the horizon to the top', () => {
  const top = [0, 0, 1] as const;
  const horizon = [0, 1, 0] as const;
  const ground = [1, 0, 0] as const;
  const sky = makeGradientSky({ top, horizon, ground });
  expect(sky.horizon[1]).toBeGreaterThan(0.85);
  const picture = paintSky({ top, horizon, ground, disc: null, clouds: null, stars: 0, boxes: [] }, 8, 64);
  const pixel = (row: number): number[] => [...picture.slice(row * 24, row * 24 + 3)];
  expect(pixel(0)[0]).toBeCloseTo(1, 1);
  expect(pixel(63)[2]).toBeCloseTo(1, 1);
});
