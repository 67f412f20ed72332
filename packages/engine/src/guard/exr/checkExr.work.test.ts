import { deflateSync } from 'node:zlib';
import { workOf } from '@farol/tools/workOf';
import { DataTexture, FloatType, RGBAFormat } from 'three';
import { EXRExporter, NO_COMPRESSION, ZIP_COMPRESSION, ZIPS_COMPRESSION } from 'three/addons/exporters/EXRExporter.js';
import { expect, test } from 'vitest';
import { readEnvironment } from '../../assets/readEnvironment';
import { checkExr } from './checkExr';

const [RLE, ZIPS, ZIP, PIZ, PXR24, DWAA] = [1, 2, 3, 4, 5, 8];
const int = (...values: number[]): Buffer => Buffer.from(new Int32Array(values).buffer);
const longs = (...values: number[]): Buffer => Buffer.from(new BigInt64Array(values.map(BigInt)).buffer);
const text = (value: string): Buffer => Buffer.from(`${value}\0`, 'latin1');
const attribute = (name: string, type: string, value: Buffer): Buffer =>
  Buffer.concat([text(name), text(type), int(value.length), value]);
const channel = (name: string): Buffer => Buffer.concat([text(name), int(1), Buffer.alloc(4), int(1, 1)]);

interface Exr {
  compression?: number;
  channels?: number;
  width?: number;
  height?: number;
  /** Attributes by name that replace the default ones. */
  attributes?: Record<string, Buffer>;
  flags?: number;
  /** Block offsets in the table, for a file of several parts. */
  places?: number[];
  blocks: Buffer[];
}

/** Makes an EXR of half floats. A block is its data, or its data with its own header. */
function exr({
  compression = ZIP,
  channels = 3,
  width = 64,
  height = 16,
  attributes = {},
  flags = 0,
  ...rest
}: Exr): ArrayBuffer {
  const all: Record<string, Buffer> = {
    channels: attribute(
      'channels',
      'chlist',
      Buffer.concat([
        ...['B', 'G', 'R', ...Array<string>(Math.max(0, channels - 3)).fill('x')].map(channel),
        Buffer.alloc(1),
      ]),
    ),
    compression: attribute('compression', 'compression', Buffer.from([compression])),
    dataWindow: attribute('dataWindow', 'box2i', int(0, 0, width - 1, height - 1)),
    ...attributes,
  };
  const head = [
    Buffer.from('v/1\x01\x02', 'latin1'),
    Buffer.from([flags, 0, 0]),
    ...Object.values(all),
    Buffer.alloc(flags & 16 ? 2 : 1),
  ];
  const end = Buffer.concat(head).length;
  const places = rest.places?.map((place) => place + end) ?? rest.blocks.map(() => 0);
  return new Uint8Array(Buffer.concat([...head, longs(...places), ...rest.blocks])).buffer;
}
const rows = (row: number, data: Uint8Array): Buffer => Buffer.concat([int(row, data.length), data]);
/** Unpacked size (bytes) of 16 rows of 64 pixels of three half floats. */
const SIZE = 64 * 16 * 6;
const zeros = (size: number): Buffer => deflateSync(Buffer.alloc(size), { level: 9 });

/** Greatest number of steps until a refusal: run lengths of half a megabyte take a quarter of a million. */
const STEPS = 500_000;

/** Error that refuses a file; 'none' when it is read. */
async function refusal(bytes: ArrayBuffer): Promise<string> {
  let message = 'none';
  const work = await workOf(() => readEnvironment(bytes, 'EXR').catch((error: Error) => (message = error.message)));
  expect(work).toBeLessThan(STEPS);
  return message;
}

test.each([NO_COMPRESSION, ZIPS_COMPRESSION, ZIP_COMPRESSION])(
  'whole pictures are read, compressed as %i',
  async (compression) => {
    const pixels = Float32Array.from({ length: 40 * 50 * 4 }, (_, i) => (i * 7) % 13);
    const source = new DataTexture(pixels, 40, 50, RGBAFormat, FloatType);
    const bytes = (await new EXRExporter().parse(source, { compression })).slice().buffer as ArrayBuffer;
    await checkExr(bytes);
    const { image } = await readEnvironment(bytes, 'EXR');
    expect(image).toMatchObject({ width: 40, height: 50 });
  },
);

test('blocks that become what they must are read', async () => {
  const runs = Buffer.from([...Array.from({ length: 3 }, () => [127, 0]).flat()]);
  const whole: Exr[] = [
    { blocks: [rows(0, zeros(SIZE))] },
    { compression: RLE, height: 1, blocks: [rows(0, runs)] },
    { compression: ZIPS, height: 1, blocks: [rows(0, zeros(SIZE / 16))] },
    { compression: PXR24, blocks: [rows(0, zeros(SIZE))] },
    { channels: 3, height: 1, blocks: [rows(0, Buffer.alloc(SIZE / 16))] },
  ];
  for (const each of whole) await expect(readEnvironment(exr(each), 'EXR')).resolves.toMatchObject({ isTexture: true });
});

const damage = /^its EXR data are damaged or cut short \((.+)\): export it again\.$/;

/** A DWA block whose run lengths unpack to a given size. */
const dwa = (numbers: number[], ...parts: Buffer[]): Buffer =>
  rows(0, Buffer.concat([longs(...numbers), Buffer.from([2, 0]), ...parts]));

test('blocks that become more than their pixels need are refused before they take memory', async () => {
  const large = { width: 4096, height: 32 };
  const megabytes = zeros(2 ** 28);
  const bomb = megabytes.subarray(0, SIZE - 1);
  const runs = Buffer.alloc(4000, 127);
  const hostile: [Exr, RegExp][] = [
    [{ blocks: [rows(0, zeros(SIZE + 1))] }, /a block of it is damaged, or becomes more/],
    [{ blocks: [rows(0, zeros(SIZE - 1))] }, /a block of it is damaged, or becomes more/],
    [{ blocks: [rows(0, Buffer.alloc(99, 1))] }, /a block of it is damaged, or becomes more/],
    [{ blocks: [rows(0, bomb)] }, /a block of it is damaged, or becomes more/],
    [{ compression: PXR24, ...large, height: 16, blocks: [rows(0, megabytes)] }, /becomes more/],
    [{ compression: RLE, height: 1, blocks: [rows(0, Buffer.alloc(300, 127))] }, /a block of it is damaged/],
    [
      {
        compression: PIZ,
        ...large,
        blocks: [rows(0, Buffer.concat([Buffer.from([1, 0, 0, 0]), int(-1), int(0, 0, 0, -1, 0)]))],
      },
      /cut short/,
    ],
    [
      { compression: DWAA, ...large, blocks: [dwa([2, 0, 0, 0, megabytes.length, 0, 0, 0, 0, 0, 0], megabytes)] },
      /becomes more/,
    ],
    [
      {
        compression: DWAA,
        ...large,
        blocks: [
          dwa(
            [2, 0, 0, 0, 0, deflateSync(Buffer.alloc(2 ** 19, 127)).length, 2 ** 19, 9, 0, 0, 0],
            deflateSync(Buffer.alloc(2 ** 19, 127)),
          ),
        ],
      },
      /a block of it is damaged/,
    ],
    [
      { compression: DWAA, ...large, blocks: [dwa([2, 0, 0, 4000, 0, 0, 0, 0, 2 ** 31, 0, 0], runs)] },
      /a block of it is damaged/,
    ],
    [
      { compression: DWAA, ...large, blocks: [dwa([2, 0, 0, 4000, 0, 0, 0, 0, 9, 0, 0], Buffer.alloc(4000))] },
      /a block of it is damaged/,
    ],
  ];
  for (const [each, message] of hostile) {
    const said = await refusal(exr(each));
    expect(said).toMatch(damage);
    expect(said).toMatch(message);
  }
});

test('one block is not read a thousand times', async () => {
  const data = Buffer.concat([int(0), rows(0, zeros(64 * 6))]);
  const attributes = { chunkCount: attribute('chunkCount', 'int', int(3000)) };
  const place = 3000 * 8;
  const bytes = exr({
    compression: ZIPS,
    height: 3000,
    flags: 16,
    attributes,
    places: Array<number>(3000).fill(place),
    blocks: [data],
  });
  expect(await refusal(bytes)).toMatch(/its blocks overlap/);
  const counts = zeros(2 ** 24);
  const row = Buffer.concat([int(0), longs(counts.length, 0, 0), counts]);
  const deep = exr({
    compression: ZIPS,
    height: 1,
    flags: 8,
    attributes: { chunkCount: attribute('chunkCount', 'int', int(1)) },
    places: [8],
    blocks: [row],
  });
  expect(await refusal(deep)).toMatch(/becomes more/);
});

test('a header that the loader would read without end, or into no picture, is refused by what is wrong with it', async () => {
  const blocks = [rows(0, zeros(SIZE))];
  const tiles = (width: number, height: number, mode: number): Record<string, Buffer> => ({
    tiles: attribute('tiles', 'tiledesc', Buffer.concat([int(width, height), Buffer.from([mode])])),
  });
  const said: [Exr, RegExp][] = [
    [{ blocks, attributes: { channels: Buffer.alloc(0) } }, /its header has no channels/],
    [{ blocks, attributes: { dataWindow: attribute('dataWindow', 'v2f', int(1, 1)) } }, /has no dataWindow/],
    [
      { blocks, attributes: { dataWindow: attribute('dataWindow', 'box2i', int(0, 0)) } },
      /dataWindow is of the wrong size/,
    ],
    [{ blocks, attributes: { other: attribute('other', 'chromaticities', int(0)) } }, /other is of the wrong size/],
    [{ blocks, attributes: { dataWindow: attribute('dataWindow', 'box2i', int(5, 5, -9, -9)) } }, /it has no pixels/],
    [{ blocks, compression: 77 }, /compressed in an unknown way/],
    [
      { blocks, attributes: { channels: attribute('channels', 'chlist', Buffer.from('R'.repeat(99))) } },
      /header is incomplete/,
    ],
    [
      {
        blocks,
        attributes: {
          channels: attribute(
            'channels',
            'chlist',
            Buffer.concat([text('R'), int(1_000_000, 0, 1, 1), Buffer.alloc(1)]),
          ),
        },
      },
      /unknown type/,
    ],
    [{ blocks, channels: 100_000, width: 1024, height: 1024 }, /100,000 channels in 64 blocks are more than is read/],
    [{ blocks, flags: 2, attributes: tiles(64, 16, 15) }, /tiles are of an unknown kind/],
    [{ blocks, flags: 2, attributes: tiles(0, 16, 0) }, /tiles are of an unknown kind/],
    [{ blocks, flags: 2, width: 1000, height: 1000, attributes: tiles(1, 1, 0) }, /in 1,000,000 blocks are more/],
    [{ blocks, flags: 16 }, /has no chunkCount/],
    [{ blocks, height: 900 }, /list of blocks is cut short|cut short/],
    [{ blocks: [rows(99, zeros(SIZE))] }, /outside its picture/],
    [{ blocks: [rows(0, zeros(SIZE)).subarray(0, 20)] }, /a block of it is cut short/],
    [{ compression: 0, height: 1, blocks: [rows(0, Buffer.alloc(9))] }, /a block of it is cut short/],
  ];
  for (const [each, message] of said) {
    const refused = await refusal(exr(each));
    expect(refused).toMatch(damage);
    expect(refused).toMatch(message);
  }
});
