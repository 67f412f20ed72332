import { crc32, deflateRawSync, gzipSync, inflateRawSync } from 'node:zlib';
import { describe, expect, test } from 'vitest';
import { parsePly } from '../geometry/parsePly';
import { readSceneFile } from '../files/readSceneFile';
import { FileError } from './FileError';
import { sizesText, unpack, unpackLimits, type UnpackQuestion } from './unpack';

interface Part {
  name: string;
  data: Uint8Array;
  /** Size in the directory, when it is not the true one (bytes). */
  says?: number;
  method?: number;
  flags?: number;
  /** Offset in the directory, when it is not the true one (bytes). */
  at?: number;
  /** CRC-32 in the directory, when it is not the true one. */
  checksum?: number;
}

/** Unpacked content of a part; '' when it cannot be unpacked. */
function contentOf({ data, method = 8 }: Part): Uint8Array | string {
  if (method === 0) return data;
  try {
    return inflateRawSync(data);
  } catch {
    return '';
  }
}

/** A ZIP of parts that are already packed. */
function zip(parts: Part[], count = parts.length): Uint8Array<ArrayBuffer> {
  const chunks: Buffer[] = [];
  const list: Buffer[] = [];
  let at = 0;
  for (const part of parts) {
    const { name, data, says = data.length, method = 8, flags = 0, at: place = at } = part;
    const title = Buffer.from(name);
    const local = Buffer.alloc(30);
    local.writeUInt32LE(0x04034b50, 0);
    local.writeUInt16LE(title.length, 26);
    chunks.push(local, title, Buffer.from(data));
    const entry = Buffer.alloc(46);
    entry.writeUInt32LE(0x02014b50, 0);
    entry.writeUInt16LE(flags, 8);
    entry.writeUInt16LE(method, 10);
    entry.writeUInt32LE(part.checksum ?? crc32(contentOf(part)), 16);
    entry.writeUInt32LE(data.length, 20);
    entry.writeUInt32LE(says, 24);
    entry.writeUInt16LE(title.length, 28);
    entry.writeUInt32LE(place, 42);
    list.push(entry, title);
    at += 30 + title.length + data.length;
  }
  const end = Buffer.alloc(22);
  end.writeUInt32LE(0x06054b50, 0);
  end.writeUInt16LE(count, 8);
  end.writeUInt16LE(count, 10);
  end.writeUInt32LE(at, 16);
  return new Uint8Array(Buffer.concat([...chunks, ...list, end]));
}

const zeros = (megabytes: number): Uint8Array<ArrayBuffer> =>
  new Uint8Array(deflateRawSync(Buffer.alloc(megabytes * 2 ** 20), { level: 9 }));
const hundred = { name: 'assets/a', data: zeros(100), checksum: crc32(Buffer.alloc(100 * 2 ** 20)) };
const small = (text: string): Uint8Array => deflateRawSync(Buffer.from(text));
const scene = { name: 'scene.json', data: small('{}'), says: 2 };

describe('a ZIP', () => {
  test('of 100 kB that becomes 100 MB is refused before it is unpacked, or asked about', async () => {
    const bomb = zip([scene, { ...hundred, says: 100 * 2 ** 20 }]);
    await expect(readSceneFile(bomb)).rejects.toThrow(/would grow from 103 kB to 105 MB .* 67 MB is the limit/);
    const asked: UnpackQuestion[] = [];
    const no = readSceneFile(bomb, (sizes) => asked.push(sizes) < 0);
    await expect(no).rejects.toMatchObject({ name: 'AbortError' });
    expect(asked.map(sizesText)).toEqual(['from 103 kB to 105 MB']);
    const { fileOf } = await readSceneFile(bomb, () => Promise.resolve(true));
    expect(fileOf('assets/a')?.size).toBe(100 * 2 ** 20);
  });

  test('that says less than it becomes is not unpacked to its end', async () => {
    await expect(readSceneFile(zip([scene, { ...hundred, says: 10 }]))).rejects.toThrow(
      /damaged \(assets\/a in it cannot be unpacked\)/,
    );
    await expect(readSceneFile(zip([{ ...scene, says: 3 }]))).rejects.toThrow(/cannot be unpacked/);
  });

  test('beyond the limit is refused without a question', async () => {
    const unasked = (): never => expect.unreachable();
    const huge = zip([scene, { name: 'a', data: zeros(1), says: 0xfffffff0 }]);
    await expect(readSceneFile(huge, unasked)).rejects.toThrow(/to 4,295 MB .* 1,074 MB is the limit/);
    const same = { name: 'a', data: zeros(1), says: 2 ** 20 };
    const overlapping = zip([scene, ...Array.from({ length: 40 }, (_, i) => ({ ...same, name: `a${i}` }))]);
    const view = new DataView(overlapping.buffer);
    for (let at = overlapping.length - 22 - 1, n = 0; n < 40; at--) {
      if (view.getUint32(at, true) !== 0x02014b50) continue;
      view.setUint32(at + 20, 2000, true);
      n++;
    }
    await expect(readSceneFile(overlapping, unasked)).rejects.toThrow(/overlap|beyond the end/);
  });

  test.each<[string, Uint8Array, RegExp]>([
    ['nothing but the letters PK', new Uint8Array([0x50, 0x4b]), /its end is not there/],
    ['no end', zip([scene]).slice(0, -10), /its end is not there/],
    ['more files than are listed', zip([scene], 9), /its list of files is not whole/],
    ['too many files', zip([scene], 20_000), /holds 20,000 files, and 10,000 is the limit/],
    ['files beyond 4 GB', zip([scene], 0xffff), /more than 4 GB/],
    ['a password', zip([{ ...scene, flags: 1 }]), /has a password/],
    ['another packing', zip([{ ...scene, method: 12 }]), /another method than Deflate/],
    ['two sizes of a stored file', zip([{ ...scene, method: 0, says: 9 }]), /two sizes/],
    ['two files of one name', zip([scene, scene]), /two files have one name/],
    ['a file that is elsewhere', zip([{ ...scene, at: 4 }]), /not where the list says/],
    ['damaged data', zip([{ ...scene, data: new Uint8Array([255, 255, 255, 255]) }]), /cannot be unpacked/],
  ])('with %s', async (_, bytes, message) => {
    await expect(readSceneFile(bytes)).rejects.toThrow(message);
    await expect(readSceneFile(bytes)).rejects.toBeInstanceOf(FileError);
  });

  test('with a file that is not what was packed says which, stored or deflated', async () => {
    const stored = { name: 'assets/robot.glb', data: Buffer.from('mesh'), method: 0 };
    const deflated = { name: 'assets/wall.png', data: small('wall'), says: 4 };
    await expect(readSceneFile(zip([scene, stored, deflated]))).resolves.toMatchObject({ text: '{}' });
    for (const part of [stored, deflated]) {
      const reading = readSceneFile(
        zip([scene, stored, deflated].map((each) => (each === part ? { ...each, checksum: 7 } : each))),
      );
      await expect(reading).rejects.toThrow(
        `The file is damaged (${part.name} in it is not what was packed): open another copy of it.`,
      );
      await expect(reading).rejects.toBeInstanceOf(FileError);
    }
    const long = zip([scene, { ...stored, name: 'x'.repeat(5000), checksum: 7 }]);
    await expect(readSceneFile(long)).rejects.toThrow(/damaged \(x{79}… in it/);
  });

  test('with files of odd names changes no prototype', async () => {
    const { fileOf } = await readSceneFile(zip([scene, { name: '__proto__', data: small('x'), says: 1 }]));
    expect(fileOf('__proto__')?.size).toBe(1);
    expect(fileOf('constructor')).toBeNull();
  });
});

describe('a stream', () => {
  test('is asked about once, when it has become large, and refused when nobody can be asked', async () => {
    await expect(unpack(hundred.data, 'deflate-raw')).rejects.toThrow(FileError);
    const asked: UnpackQuestion[] = [];
    const whole = await unpack(hundred.data, 'deflate-raw', { mayUnpack: (sizes) => asked.push(sizes) > 0 });
    expect(whole.length).toBe(100 * 2 ** 20);
    expect(asked).toHaveLength(1);
  });

  test('of gzip in a PLY', async () => {
    const bomb = new Uint8Array(gzipSync(Buffer.alloc(unpackLimits.free + 2 ** 20))).buffer;
    await expect(parsePly(bomb)).rejects.toThrow(/would grow from \d+ kB to \d+ MB/);
  });
});

test.each([
  ['element foo 4000000000\n', /is too short for 4000000000 of the element foo/],
  ['element vertex 4000000000\nproperty float x\n', /is too short for 4000000000 of the element vertex/],
  ['element vertex -1\nproperty float x\n', /is too short for -1/],
  ['element face 3\nproperty list uint int vertex_indices\n', /damaged or cut short/],
])('a PLY with %j', async (elements, message) => {
  const header = `ply\nformat binary_little_endian 1.0\n${elements}end_header\n`;
  const bytes = new Uint8Array([...new TextEncoder().encode(header), ...Array.from({ length: 64 }, () => 255)]);
  await expect(parsePly(bytes.buffer)).rejects.toThrow(message);
});

test('a header of a PLY without an end', async () => {
  await expect(parsePly(new TextEncoder().encode('ply\nformat ascii 1.0\n').buffer as ArrayBuffer)).rejects.toThrow(
    /header of the PLY file is incomplete/,
  );
});
