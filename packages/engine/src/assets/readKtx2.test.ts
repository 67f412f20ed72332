import { describe, expect, test } from 'vitest';
import { AssetLibrary } from './AssetLibrary';

/** A KTX2 of 2 × 2 texels of RGBA, sRGB, uncompressed: header, level index, data format, orientation, texels. */
function ktx2(orientation: string | null, { depth = 0, cut = Infinity } = {}): Uint8Array<ArrayBuffer> {
  const keyValue = orientation === null ? '' : `KTXorientation\0${orientation}\0`;
  const keyValueLength = keyValue === '' ? 0 : 4 + Math.ceil(keyValue.length / 4) * 4;
  const dfd = 80 + 24;
  const dfdLength = 4 + 24 + 4 * 16;
  const texels = Math.ceil((dfd + dfdLength + keyValueLength) / 4) * 4;
  const bytes = new Uint8Array(texels + 16);
  const view = new DataView(bytes.buffer);
  bytes.set([0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 0x0d, 0x0a, 0x1a, 0x0a]);
  // vkFormat R8G8B8A8_SRGB, type size, width, height, depth, layers, faces, levels, scheme
  [43, 1, 2, 2, depth, 0, 1, 1, 0].forEach((word, i) => view.setUint32(12 + i * 4, word, true));
  [dfd, dfdLength, keyValueLength ? dfd + dfdLength : 0, keyValueLength].forEach((word, i) =>
    view.setUint32(48 + i * 4, word, true),
  );
  [texels, 0, 16, 0, 16, 0].forEach((word, i) => view.setUint32(80 + i * 4, word, true));
  view.setUint32(dfd, dfdLength, true);
  view.setUint16(dfd + 8, 2, true);
  view.setUint16(dfd + 10, dfdLength - 4, true);
  // model RGBSDA, primaries BT.709, transfer sRGB; a plane of 4 bytes
  bytes.set([1, 1, 2, 0, 0, 0, 0, 0, 4], dfd + 12);
  [0, 1, 2, 15].forEach((channel, i) => {
    const sample = dfd + 28 + i * 16;
    view.setUint16(sample, i * 8, true);
    bytes.set([7, channel], sample + 2);
    view.setUint32(sample + 12, 255, true);
  });
  if (keyValueLength) {
    view.setUint32(dfd + dfdLength, keyValue.length, true);
    bytes.set(new TextEncoder().encode(keyValue), dfd + dfdLength + 4);
  }
  bytes.set([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16], texels);
  return bytes.slice(0, cut);
}

/** Stands for the renderer of a device without compressed formats. */
const renderer = { isWebGPURenderer: true, hasFeature: () => false } as never;

async function load(bytes: Uint8Array<ArrayBuffer>, name = 'wall.ktx2', options: object = { renderer }) {
  const assets = new AssetLibrary(options);
  assets.registerFile(name, new Blob([bytes]));
  await assets.load(name);
  return { assets, texture: assets.texture(name) };
}

describe('a KTX2', () => {
  test('is a texture, turned the right way up', async () => {
    const { texture } = await load(ktx2('rd'));
    expect(texture.image).toMatchObject({ width: 2, height: 2 });
    expect(texture.colorSpace).toBe('srgb');
    texture.updateMatrix();
    const [, , , , sy, , , ty] = texture.matrix.elements;
    expect([sy, ty]).toEqual([-1, 1]);
    const upright = await load(ktx2('ru'));
    expect(upright.texture.repeat.y).toBe(1);
    expect((await load(ktx2(null))).texture.repeat.y).toBe(-1);
  });

  test('lies on a material as its fields say', async () => {
    const { assets } = await load(ktx2('rd'));
    const material = assets.addMaterial('Wall', { map: 'wall.ktx2', mapRepeatY: 3, mapOffsetY: 0.25 });
    const { map } = material.three as unknown as { map: { matrix: { elements: number[] } } };
    // 1 - (3 v + 0.25)
    expect([map.matrix.elements[4], map.matrix.elements[7]]).toEqual([-3, 0.75]);
  });

  test('that cannot be read says why', async () => {
    await expect(load(ktx2('rd', { cut: 60 }))).rejects.toThrow("'wall.ktx2' could not be loaded: it is cut short");
    await expect(load(ktx2('rd', { cut: 190 }))).rejects.toThrow(/its KTX2 data are damaged or cut short/);
    await expect(load(ktx2('rd', { depth: 4 }))).rejects.toThrow(/a cube, an array or a volume/);
    await expect(load(ktx2('rd'), 'wall.ktx2', {})).rejects.toThrow(/give the AssetLibrary your WebGLRenderer/);
    const png = Uint8Array.from([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10]);
    await expect(load(png)).rejects.toThrow(/its bytes are PNG, not KTX2/);
  });
});
