import { DataUtils } from 'three';
import { HDRLoader } from 'three/addons/loaders/HDRLoader.js';
import { expect, test } from 'vitest';
import { readEnvironment } from './readEnvironment';

/** Pixel in the format of Radiance: red, green, blue and exponent. */
type Pixel = readonly [number, number, number, number];

const bytesOf = (head: string, ...rows: readonly number[][]): ArrayBuffer =>
  new Uint8Array([...Buffer.from(head, 'latin1'), ...rows.flat()]).buffer;
const head = (size: string, format = 'FORMAT=32-bit_rle_rgbe\n'): string => `#?RADIANCE\n${format}\n${size}\n`;

/** A picture whose pixels are all different, with runs. */
const pixelsOf = (width: number, height: number): Pixel[] =>
  Array.from({ length: width * height }, (_, i) => [128 + (i % 100), i % 7, (i >> 3) % 200, 128 + (i % 5)]);

/** A row in run lengths: all red values, then green, blue and exponents. */
function packedRow(pixels: readonly Pixel[]): number[] {
  const bytes = [2, 2, pixels.length >> 8, pixels.length & 255];
  for (let channel = 0; channel < 4; channel++) {
    for (let at = 0; at < pixels.length;) {
      let run = 1;
      while (run < 127 && pixels[at + run]?.[channel] === pixels[at][channel]) run++;
      if (run > 2) {
        bytes.push(128 + run, pixels[at][channel]);
        at += run;
      } else bytes.push(1, pixels[at++][channel]);
    }
  }
  return bytes;
}
const rowsOf = (pixels: readonly Pixel[], width: number): Pixel[][] =>
  Array.from({ length: pixels.length / width }, (_, y) => pixels.slice(y * width, (y + 1) * width));

interface Image {
  readonly width: number;
  readonly height: number;
  readonly data: Uint16Array;
}
const read = async (bytes: ArrayBuffer): Promise<Image> => (await readEnvironment(bytes, 'HDR')).image as Image;
/** Red of each pixel, decoded. */
const redOf = ({ data }: Image): number[] =>
  Array.from({ length: data.length / 4 }, (_, i) => DataUtils.fromHalfFloat(data[i * 4]));
const light = ([red, , , exponent]: Pixel): number => (red * 2 ** (exponent - 128)) / 255;

test('a picture is the one of three’s loader, packed and flat', async () => {
  const pixels = pixelsOf(40, 9);
  const rows = rowsOf(pixels, 40);
  for (const bytes of [
    bytesOf(head('-Y 9 +X 40'), ...rows.map(packedRow)),
    bytesOf(head('-Y 9 +X 40'), ...rows.map((row) => row.flat())),
  ]) {
    const { data, width, height } = new HDRLoader().parse(bytes) as unknown as Image;
    expect(await read(bytes)).toMatchObject({ width, height, data });
  }
});

test('rows and columns go where the header says', async () => {
  const pixels = pixelsOf(3, 2);
  const expected = pixels.map(light);
  const order: Readonly<Record<string, readonly number[]>> = {
    '-Y 2 +X 3': [0, 1, 2, 3, 4, 5],
    '+Y 2 +X 3': [3, 4, 5, 0, 1, 2],
    '-Y 2 -X 3': [2, 1, 0, 5, 4, 3],
    '+X 3 -Y 2': [0, 3, 1, 4, 2, 5],
    '-X 3 +Y 2': [5, 2, 4, 1, 3, 0],
  };
  for (const [size, at] of Object.entries(order)) {
    const image = await read(bytesOf(head(size), ...at.map((i) => [...pixels[i]])));
    expect(image, size).toMatchObject({ width: 3, height: 2 });
    redOf(image).forEach((red, i) => expect(red, size).toBeCloseTo(expected[i], 2));
  }
});

test('flat rows that begin with 2 2 are read, among packed ones too, and runs of the old kind', async () => {
  const row = pixelsOf(8, 1);
  const odd: Pixel[] = [[2, 2, 3, 140], ...row.slice(1)];
  const image = await read(bytesOf(head('-Y 3 +X 8'), odd.flat(), packedRow(row), odd.flat()));
  redOf(image).forEach((red, i) => expect(red).toBeCloseTo(light((Math.floor(i / 8) === 1 ? row : odd)[i % 8]), 1));
  const old = await read(bytesOf(head('-Y 1 +X 8'), [128, 0, 0, 129], [1, 1, 1, 6], [64, 0, 0, 129]));
  expect(redOf(old).map((red) => Math.round(red * 255))).toEqual([256, 256, 256, 256, 256, 256, 256, 128]);
});

test('a header without a format, with breaks of other systems, is read; colours of another kind are named', async () => {
  expect(await read(bytesOf(head('-Y 1 +X 1', ''), [128, 128, 128, 128]))).toMatchObject({ width: 1 });
  const breaks = '#?RGBE\r\n# by hand\r\nFORMAT=32-bit_rle_rgbe\r\n\r\n-Y 1 +X 1\r\n';
  expect(await read(bytesOf(breaks, [128, 128, 128, 128]))).toMatchObject({ width: 1 });
  await expect(read(bytesOf(head('-Y 1 +X 1', 'FORMAT=32-bit_rle_xyze\n'), [1, 1, 1, 1]))).rejects.toThrow(/xyze/);
});

test('what is cut short anywhere, or damaged, is refused', async () => {
  const rows = rowsOf(pixelsOf(40, 9), 40);
  for (const bytes of [
    bytesOf(head('-Y 9 +X 40'), ...rows.map(packedRow)),
    bytesOf(head('-Y 9 +X 40'), ...rows.map((row) => row.flat())),
  ]) {
    for (let cut = 1; cut < bytes.byteLength; cut += 7) {
      await expect(read(bytes.slice(0, bytes.byteLength - cut)), `${cut} bytes`).rejects.toThrow(
        /^its HDR data are damaged or cut short \(.+\): export it again\.$/,
      );
    }
  }
  const long = packedRow(rows[0]);
  long[4] = 255;
  await expect(read(bytesOf(head('-Y 1 +X 40'), long))).rejects.toThrow(/damaged or cut short/);
  await expect(read(bytesOf(head('-Y 1 +X 8'), [1, 1, 1, 8]))).rejects.toThrow(/damaged or cut short/);
});
