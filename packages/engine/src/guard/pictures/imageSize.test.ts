import { expect, test } from 'vitest';
import { imageSize } from './imageSize';

const png = (width: number, height: number): Uint8Array => {
  const bytes = new Uint8Array(40);
  bytes.set([0x89, 0x50, 0x4e, 0x47]);
  new DataView(bytes.buffer).setUint32(16, width);
  new DataView(bytes.buffer).setUint32(20, height);
  return bytes;
};
const letters = (text: string): number[] => [...text].map((letter) => letter.charCodeAt(0));
const of = (...numbers: number[]): Uint8Array => new Uint8Array([...numbers, ...Array.from({ length: 40 }, () => 0)]);

test('tell their size', () => {
  expect(imageSize(png(640, 480))).toEqual({ width: 640, height: 480 });
  const jpeg = of(0xff, 0xd8, 0xff, 0xe0, 0, 4, 0, 0, 0xff, 0xc2, 0, 11, 8, 0x01, 0x00, 0x02, 0x00);
  expect(imageSize(jpeg)).toEqual({ width: 512, height: 256 });
  const hdr = new TextEncoder().encode(`#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16 +X 32\n${' '.repeat(40)}`);
  expect(imageSize(hdr)).toEqual({ width: 32, height: 16 });
  const webp = new Uint8Array(40);
  webp.set(new TextEncoder().encode('RIFF    WEBPVP8X'));
  webp.set([255, 1, 0, 127, 0, 0], 24);
  expect(imageSize(webp)).toEqual({ width: 512, height: 128 });
  expect(imageSize(of(1, 2, 3))).toBeNull();
  // bytes between segments, and markers without a segment, are skipped, as in decoders
  const odd = of(0xff, 0xd8, 0xff, 0x01, 7, 8, 0xff, 0xd0, 0xff, 0xff, 0xc0, 0, 11, 8, 0x01, 0x00, 0x02, 0x00);
  expect(imageSize(odd)).toEqual({ width: 512, height: 256 });
  const tabs = new TextEncoder().encode(`#?RADIANCE\n${`# ${'x'.repeat(80)}\n`.repeat(60)}\n-Y\t16\t+X\t32\n`);
  expect(imageSize(tabs)).toEqual({ width: 32, height: 16 });
  // other formats of browsers, which may have a wrong extension
  expect(imageSize(of(...letters('GIF89a'), 0x00, 0x02, 0x00, 0x01))).toEqual({ width: 512, height: 256 });
  const bmp = [...letters('BM'), ...Array.from({ length: 12 }, () => 0), 40, 0, 0, 0, 0, 2, 0, 0, 0, 0xff, 0xff, 0xff];
  expect(imageSize(of(...bmp))).toEqual({ width: 512, height: 256 });
  const [small, large] = [
    [0, 0, 0, 16, 0, 0, 0, 16],
    [0, 0, 2, 0, 0, 0, 1, 0],
  ].map((size) => [...letters('ispe'), 0, 0, 0, 0, ...size]);
  const avif = [0, 0, 0, 20, ...letters('ftypavif'), 0, 0, 0, 0, ...small, ...large];
  expect(imageSize(of(...avif))).toEqual({ width: 512, height: 256 });
  const ktx2 = of(
    0xab,
    ...letters('KTX 20'),
    0xbb,
    13,
    10,
    26,
    10,
    ...Array.from({ length: 8 }, () => 0),
    0,
    2,
    0,
    0,
    0,
    1,
  );
  expect(imageSize(ktx2)).toEqual({ width: 512, height: 256 });
  expect(imageSize(of(0xff, 0xd8, 0, 0))).toBeNull();
});
