import type { Texture } from 'three';
import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import { deserialize } from '../files/deserialize';
import { writeGlb } from '../files/writeGlb';
import { AssetLibrary } from './AssetLibrary';
import { readModel } from './readModel';
import type { Sound } from './Sound';

/** The header of a PNG; `salt` makes its bytes unique. */
function png(width: number, height: number, salt = 0): Blob {
  const bytes = new Uint8Array(64);
  bytes.set([0x89, 0x50, 0x4e, 0x47, 13, 10, 26, 10, 0, 0, 0, 13, 0x49, 0x48, 0x44, 0x52]);
  const view = new DataView(bytes.buffer);
  view.setUint32(16, width);
  view.setUint32(20, height);
  bytes[63] = salt;
  return new Blob([bytes]);
}

const decode = vi.fn<(blob: Blob) => Promise<object>>(() => Promise.resolve({ width: 1, height: 1 }));

beforeEach(() => {
  decode.mockClear();
  vi.stubGlobal('createImageBitmap', decode);
});
afterEach(() => vi.unstubAllGlobals());

/** Result of loading each asset: '' or the error's message. */
const outcomes = (library: AssetLibrary, names: readonly string[]): Promise<string[]> =>
  Promise.all(
    names.map((name) =>
      library.load(name).then(
        () => '',
        (error: Error) => error.message,
      ),
    ),
  );

const twelve = Array.from({ length: 12 }, (_, i) => `${i}.png`);
const REFUSED = /would take [\d,]+ MB once decoded, and [\d,]+ MB is the limit for files of so few bytes/;

describe('the pictures of a library', () => {
  test('are counted together before they are decoded', async () => {
    const library = new AssetLibrary();
    twelve.forEach((name, i) => library.registerFile(name, png(8192, 8192, i)));
    const said = await outcomes(library, twelve);
    expect(said.filter((each) => each === '')).toHaveLength(4);
    expect(said.filter((each) => REFUSED.test(each))).toHaveLength(8);
    expect(decode).toHaveBeenCalledTimes(4);
    // removing one asset makes room
    library.unregister(twelve[said.indexOf('')]);
    expect(await outcomes(library, [twelve[said.findIndex((each) => each !== '')]])).toEqual(['']);
  });

  test('may come to more where their files are large', async () => {
    const library = new AssetLibrary();
    const bytes = new Uint8Array(8 * 2 ** 20);
    twelve.forEach((name, i) => library.registerFile(name, new Blob([png(8192, 8192, i), bytes])));
    expect(await outcomes(library, twelve)).toEqual(twelve.map(() => ''));
  });

  test('that are equal are decoded once, also where the first goes', async () => {
    const library = new AssetLibrary();
    for (const name of twelve) library.registerFile(name, png(8192, 8192));
    expect(await outcomes(library, twelve)).toEqual(twelve.map(() => ''));
    expect(decode).toHaveBeenCalledTimes(1);
    const [first, second] = twelve.map((name) => library.get(name) as Texture);
    expect(second).not.toBe(first);
    expect(second.source).toBe(first.source);
    library.unregister('0.png');
    library.registerFile('again.png', png(8192, 8192));
    await library.load('again.png');
    expect(decode).toHaveBeenCalledTimes(1);
  });

  test('of KTX2 and HDR count too', async () => {
    const library = new AssetLibrary();
    const four = twelve.slice(0, 4);
    four.forEach((name, i) => library.registerFile(name, png(8192, 8192, i)));
    expect(await outcomes(library, four)).toEqual(four.map(() => ''));
    library.registerFile('late.hdr', new Blob(['#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8192 +X 8192\n\0\0']));
    const ktx2 = new Uint8Array(80);
    ktx2.set([0xab, 0x4b, 0x54, 0x58, 0x20, 0x32, 0x30, 0xbb, 13, 10, 26, 10]);
    new DataView(ktx2.buffer).setUint32(20, 8192, true);
    new DataView(ktx2.buffer).setUint32(24, 8192, true);
    library.registerFile('late.ktx2', new Blob([ktx2]));
    for (const said of await outcomes(library, ['late.hdr', 'late.ktx2'])) expect(said).toMatch(REFUSED);
  });

  test('of a link of a thousand letters are refused with it', async () => {
    const url = async (i: number): Promise<string> =>
      `data:image/png;base64,${Buffer.from(await png(8192, 8192, i).arrayBuffer()).toString('base64')}`;
    const assets = await Promise.all(twelve.map(async (name, i) => ({ name, type: 'texture', url: await url(i) })));
    const object = (map: string, i: number): object => ({
      id: `o${i}`,
      name: `o${i}`,
      parent: null,
      components: [
        { type: 'Transform', version: 1, id: `t${i}`, values: {} },
        { type: 'ObjectRenderer', version: 1, id: `r${i}`, values: { map } },
      ],
    });
    const file = {
      format: 'farol-scene',
      version: 2,
      name: 'Heavy',
      settings: {},
      activeCamera: null,
      assets,
      objects: twelve.map(object),
    };
    await expect(deserialize(file)).rejects.toThrow(REFUSED);
    expect(decode.mock.calls.length).toBeLessThanOrEqual(4);
  });
});

describe('within a model', () => {
  const model = async (salts: readonly number[]): Promise<ArrayBuffer> => {
    const pictures = await Promise.all(
      salts.map(async (salt) => new Uint8Array(await png(8192, 8192, salt).arrayBuffer())),
    );
    const json = {
      asset: { version: '2.0' },
      buffers: [{ byteLength: 64 * salts.length }],
      bufferViews: salts.map((_, i) => ({ buffer: 0, byteOffset: i * 64, byteLength: 64 })),
      images: salts.map((_, i) => ({ bufferView: i, mimeType: 'image/png' })),
      textures: salts.map((_, i) => ({ source: i })),
      materials: salts.map((_, i) => ({ pbrMetallicRoughness: { baseColorTexture: { index: i } } })),
      nodes: [{}],
      scenes: [{ nodes: [0] }],
      scene: 0,
    };
    return writeGlb(JSON.stringify(json), pictures, 64 * salts.length);
  };

  test('pictures are counted together', async () => {
    await expect(readModel(await model(twelve.map((_, i) => i)))).rejects.toThrow(REFUSED);
    expect(decode).not.toHaveBeenCalled();
  });

  test('and with those of others', async () => {
    const library = new AssetLibrary();
    const names = await Promise.all(
      [0, 1, 2].map(async (i) => {
        library.registerFile(`${i}.glb`, new Blob([await model([i * 2, i * 2 + 1])]));
        return `${i}.glb`;
      }),
    );
    const said = await outcomes(library, names);
    expect(said.filter((each) => REFUSED.test(each))).toHaveLength(1);
  });
});

test('sounds are counted together before they are decoded', async () => {
  const decodeAudioData = vi.fn<(bytes: ArrayBuffer) => Promise<object>>(() => Promise.resolve({}));
  vi.stubGlobal(
    'OfflineAudioContext',
    class {
      readonly decodeAudioData = decodeAudioData;
    },
  );
  // 8 kbit/s at 8,000 Hz: 1.1 MB decode to 415 MB
  const mp3 = new Uint8Array(72 * 15_000);
  for (let at = 0; at < mp3.length; at += 72) mp3.set([0xff, 0xe3, 0x18, 0x40], at);
  const library = new AssetLibrary();
  const ends: string[] = [];
  for (let i = 0; i < 3; i++) {
    library.registerFile(`${i}.mp3`, new Blob([mp3]));
    const sound = (await library.load(`${i}.mp3`)) as Sound;
    ends.push(
      await sound.decode().then(
        () => '',
        (error: Error) => error.message,
      ),
    );
  }
  expect(ends).toEqual(['', '', expect.stringMatching(REFUSED)]);
  expect(decodeAudioData).toHaveBeenCalledTimes(2);
});
