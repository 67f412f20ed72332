import { readFileSync } from 'node:fs';
import { afterEach, expect, test, vi } from 'vitest';
import { Sound } from '../../assets/Sound';
import { checkSound, soundSize } from './checkSound';

const bytesOf = (...parts: (Buffer | string | readonly number[])[]): ArrayBuffer =>
  new Uint8Array(
    Buffer.concat(parts.map((part) => (typeof part === 'string' ? Buffer.from(part, 'latin1') : Buffer.from(part)))),
  ).buffer;
const u16 = (value: number): Buffer => Buffer.from([value & 255, value >> 8]);
const u32 = (value: number): Buffer => {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32LE(value >>> 0);
  return bytes;
};
const u32be = (value: number): Buffer => u32(value).reverse();

interface Wav {
  format?: number;
  channels?: number;
  rate?: number;
  bits?: number;
  /** Size in the header (bytes). */
  says?: number;
  /** True size (bytes). */
  has: number;
}

const wav = ({ format = 1, channels = 1, rate = 48_000, bits = 16, has, says = has }: Wav): ArrayBuffer =>
  bytesOf(
    ...['RIFF', u32(36 + says), 'WAVEfmt ', u32(16), u16(format), u16(channels), u32(rate), u32(0), u16(1), u16(bits)],
    ...['data', u32(says), Buffer.alloc(has)],
  );

/** Header of a FLAC frame of 65,536 samples, with its checksum. */
function flacFrame(): Buffer {
  const head = [0xff, 0xf8, 0x79, 0x18, 0, 0xff, 0xff];
  let crc = 0;
  for (const byte of head) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = crc & 0x80 ? ((crc << 1) ^ 7) & 0xff : crc << 1;
  }
  return Buffer.from([...head, crc, 0, 0, 0, 0, 0, 0]);
}
/** FLAC header with rate 48,000, 8 channels and unknown length. */
const flacHead = (): Buffer =>
  Buffer.concat([
    Buffer.from('fLaC\x80\0\0\x22', 'latin1'),
    Buffer.alloc(10),
    u32be((48_000 << 12) | (7 << 9)),
    Buffer.alloc(20),
  ]);

/** A page of an Ogg of whole packets. @param said - granule position of the page */
const oggPage = (packets: readonly Buffer[], said: number, flags = 0): Buffer =>
  Buffer.concat([
    ...[Buffer.from('OggS\0'), Buffer.from([flags]), u32(said), u32(said < 0 ? -1 : Math.floor(said / 2 ** 32))],
    ...[Buffer.alloc(12), Buffer.from([packets.length, ...packets.map(({ length }) => length)]), ...packets],
  ]);
const opusHead = Buffer.from('OpusHead\x01\x02\0\0\0\0\0\0\0\0\0', 'latin1');
const vorbisHead = Buffer.concat([
  Buffer.from('\x01vorbis\0\0\0\0\x02', 'latin1'),
  u32(44_100),
  Buffer.alloc(12),
  Buffer.from([0xb8, 1]),
]);

const box = (name: string, ...parts: Buffer[]): Buffer => {
  const data = Buffer.concat(parts);
  return Buffer.concat([u32be(8 + data.length), Buffer.from(name), data]);
};
const mp4 = ({ duration = 48_000, count = 24, codec = 'mp4a' }): ArrayBuffer => {
  const entry = Buffer.alloc(36);
  entry.write(codec, 4);
  entry.writeUInt16BE(48_000, 32);
  const table = box('stbl', box('stsd', u32be(0), u32be(1), entry), box('stsz', u32be(0), u32be(1), u32be(count)));
  const media = box(
    'mdia',
    box('mdhd', Buffer.alloc(12), u32be(48_000), u32be(duration), Buffer.alloc(12)),
    box('minf', table),
  );
  return bytesOf(box('ftyp', Buffer.alloc(16)), box('moov', box('trak', media)), box('mdat', Buffer.alloc(2e6)));
};

/** Frames of an MP3 of 8 kbit/s and 8,000 Hz: 72 bytes, 576 samples each. */
const mp3 = (frames: number): Buffer => {
  const frame = Buffer.alloc(72);
  frame.set([0xff, 0xe3, 0x18, 0x40]);
  return Buffer.concat(Array.from({ length: frames }, () => frame));
};
const aac = (frames: number): Buffer =>
  Buffer.concat(Array.from({ length: frames }, () => Buffer.from([0xff, 0xf1, 0x6c, 0x80, 0x01, 0x1f, 0xfc, 0, 0])));

const lengthOf = (bytes: ArrayBuffer): number => Number(soundSize(bytes)!.seconds.toFixed(3));

test('sounds are as long as their own data, whatever their headers say', () => {
  expect(lengthOf(wav({ has: 96_000 }))).toBe(1);
  expect(lengthOf(wav({ has: 96_000, says: 0xffffffff }))).toBe(1);
  expect(soundSize(wav({ has: 96_000, channels: 4, bits: 8 }))).toEqual({ seconds: 0.5, channels: 4, rate: 48_000 });
  expect(lengthOf(bytesOf(flacHead(), ...Array.from({ length: 30 }, flacFrame)))).toBeCloseTo(
    (30 * 65_536) / 48_000,
    3,
  );
  expect(soundSize(bytesOf('ID3\x04\0\0\0\0\x01\x00', Buffer.alloc(128), flacHead(), flacFrame()))?.channels).toBe(8);
  expect(lengthOf(bytesOf(mp3(100)))).toBe(7.2);
  expect(lengthOf(bytesOf('ID3\x04\0\0\0\0\x01\x00', Buffer.alloc(128), mp3(100)))).toBe(7.2);
  expect(lengthOf(bytesOf(aac(4)))).toBe(0.512);
  expect(lengthOf(mp4({}))).toBe(1);
  expect(lengthOf(mp4({ count: 96 }))).toBe(2.048);
  expect(lengthOf(mp4({ duration: 96_000 }))).toBe(2);
  // 20 ms, and three of 20 ms
  const packets = [Buffer.from([0x08, 1]), Buffer.from([0x0b, 3])];
  expect(lengthOf(bytesOf(oggPage([opusHead], 0, 2), oggPage(packets, -1)))).toBe(0.2);
  const vorbis = Array.from({ length: 200 }, () => Buffer.from([0]));
  expect(lengthOf(bytesOf(oggPage([vorbisHead], 0, 2), oggPage(vorbis, 88_200)))).toBe(2);
});

const steps = readFileSync(new URL('../../../../../public/sounds/step.wav', import.meta.url));

test('a sound that would take gigabytes is refused before it is decoded', () => {
  const refused: [string, ArrayBuffer][] = [
    ['a WAV of a low rate', wav({ has: 30e6, rate: 3000, bits: 8 })],
    ['MP3', bytesOf(mp3(40_000))],
    ['AAC', bytesOf(aac(60_000))],
    ['FLAC of silence', bytesOf(flacHead(), ...Array.from({ length: 2000 }, flacFrame))],
    [
      'Ogg Opus of silence',
      bytesOf(
        oggPage([opusHead], 0, 2),
        ...Array.from({ length: 60 }, () =>
          oggPage(
            Array.from({ length: 255 }, () => Buffer.from([0x1b, 2])),
            -1,
          ),
        ),
      ),
    ],
    ['Ogg Vorbis', bytesOf(oggPage([vorbisHead], 0, 2), oggPage([], 44_100 * 3600))],
    ['M4A', mp4({ count: 1_000_000 })],
  ];
  for (const [name, bytes] of refused) {
    expect(() => checkSound(bytes, 48_000), name).toThrow(
      /^it would take [\d,]+ MB once it is decoded \(\d+ minutes\), and 537 MB is the limit: make it shorter\.$/,
    );
  }
  for (const bytes of [wav({ has: 1e6 }), bytesOf(mp3(1000)), bytesOf(steps)]) checkSound(bytes, 48_000);
});

test.each<[string, ArrayBuffer]>([
  ['nothing', bytesOf('')],
  ['a WAV without data', bytesOf('RIFF', u32(4), 'WAVE', Buffer.alloc(40))],
  ['an Ogg of no sound', bytesOf(oggPage([Buffer.from('fishead')], 0, 2), Buffer.alloc(30))],
  ['an Ogg that is cut short', bytesOf(oggPage([opusHead], 0, 2).subarray(0, 27))],
  ['a FLAC that is cut short', bytesOf('fLaC', Buffer.alloc(12))],
  ['an MP4 of another codec', mp4({ codec: 'fLaC' })],
  [
    'an MP4 of boxes in boxes',
    bytesOf(box('ftyp', Buffer.alloc(8)), ...Array.from({ length: 50_000 }, () => '\xff\xff\xff\xffmoov')),
  ],
  ['zeros', bytesOf(Buffer.alloc(1000))],
])('%s is refused by name', (_, bytes) => {
  expect(() => checkSound(bytes, 48_000)).toThrow(/^it cannot be decoded: convert it/);
});

afterEach(() => vi.unstubAllGlobals());

test('the browser is not asked to decode what is refused', async () => {
  const decodeAudioData = vi.fn<(bytes: ArrayBuffer) => Promise<number>>((bytes) => Promise.resolve(bytes.byteLength));
  vi.stubGlobal(
    'OfflineAudioContext',
    class {
      readonly decodeAudioData = decodeAudioData;
    },
  );
  await expect(new Sound(bytesOf(mp3(40_000))).decode()).rejects.toThrow(/would take/);
  expect(decodeAudioData).not.toHaveBeenCalled();
  await expect(new Sound(bytesOf(steps)).decode()).resolves.toBe(steps.length);
});
