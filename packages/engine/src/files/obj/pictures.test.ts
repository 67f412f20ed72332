import { describe, expect, it } from 'vitest';
import { decodeTga } from './decodePicture';
import { encodePng } from './encodePng';
import { holdsNormals, isCutOut, normalsOfHeights, type Picture, roughnessOfSpecular, withOpacity } from './pictures';
import { tga } from './testing/tga';

describe('pictures', () => {
  const pictureOf = (width: number, height: number, texel: (x: number, y: number) => number[]): Picture => {
    const data = new Uint8Array(width * height * 4);
    for (let y = 0; y < height; y++) for (let x = 0; x < width; x++) data.set(texel(x, y), (y * width + x) * 4);
    return { width, height, data };
  };

  it('reads a TGA with the first row on top', () => {
    const texels = [
      [1, 2, 3, 255],
      [4, 5, 6, 128],
    ];
    expect([...decodeTga(tga(1, 2, texels)).data]).toEqual([4, 5, 6, 128, 1, 2, 3, 255]);
    expect(() => decodeTga(Uint8Array.from([0, 0, 2]))).toThrow('cut short');
    expect(() => decodeTga(tga(1, 2, texels).slice(0, 20))).toThrow('cut short');
    expect(() => decodeTga(Uint8Array.from([0, 0, 2, ...Array.from({ length: 27 }, () => 255)]))).toThrow(
      '65535 × 65535 pixels',
    );
  });

  it('writes a PNG that gives the picture back, colours without alpha too', async () => {
    const picture = pictureOf(3, 2, (x, y) => [x * 100, y * 200, 7, x === 1 ? 0 : 255]);
    const bytes = await encodePng(picture);
    const view = new DataView(bytes.buffer);
    expect([view.getUint32(16), view.getUint32(20), bytes[24], bytes[25]]).toEqual([3, 2, 8, 6]);
    const length = view.getUint32(33);
    const packed = bytes.slice(41, 41 + length);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
    const rows = new Uint8Array(await new Response(stream).arrayBuffer());
    const texels = [0, 1].flatMap((y) => {
      const row = [...rows.slice(y * 13 + 1, y * 13 + 13)];
      for (let i = 4; i < 12; i++) row[i] = (row[i] + row[i - 4]) & 255;
      return row;
    });
    expect(texels).toEqual([...picture.data]);
  });

  it('turns heights into normals that lean away from what rises', () => {
    // two height maps: one rises to the right, the other to the top
    const right = normalsOfHeights(
      pictureOf(8, 8, (x) => [x * 20, x * 20, x * 20, 255]),
      1,
    );
    const middle = (4 * 8 + 4) * 4;
    expect(right.data[middle]).toBeLessThan(110);
    expect(right.data[middle + 1]).toBe(128);
    const up = normalsOfHeights(
      pictureOf(8, 8, (_, y) => [(7 - y) * 20, (7 - y) * 20, (7 - y) * 20, 255]),
      1,
    );
    expect(up.data[middle + 1]).toBeLessThan(110);
    expect(holdsNormals(right)).toBe(true);
    expect(holdsNormals(pictureOf(8, 8, (x) => [x * 20, x * 20, x * 20, 255]))).toBe(false);
    expect(holdsNormals(pictureOf(8, 8, () => [20, 40, 200, 255]))).toBe(false);
  });

  it('puts opacity into the alpha: by alpha where there is one, else by brightness', () => {
    const red = pictureOf(2, 2, () => [255, 0, 0, 255]);
    const grey = pictureOf(4, 4, (x) => (x < 2 ? [0, 0, 0, 255] : [255, 255, 255, 255]));
    expect([...withOpacity(red, grey).data.slice(0, 8)]).toEqual([255, 0, 0, 0, 255, 0, 0, 255]);
    const leaf = pictureOf(2, 2, (x) => [0, 255, 0, x * 200]);
    expect([...withOpacity(null, leaf).data.slice(0, 8)]).toEqual([255, 255, 255, 0, 255, 255, 255, 200]);
    expect(isCutOut(withOpacity(red, grey))).toBe(true);
    expect(isCutOut(withOpacity(null, leaf))).toBe(false);
  });

  it('turns strong highlights into low roughness', () => {
    const { data } = roughnessOfSpecular(
      pictureOf(2, 1, (x) => [x * 255, x * 255, x * 255, 255]),
      0.4,
    );
    expect([data[1], data[5]]).toEqual([255, 102]);
  });
});
