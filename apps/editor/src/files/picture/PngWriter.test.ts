import { inflateSync } from 'node:zlib';
import { expect, it } from 'vitest';
import { PngWriter } from './PngWriter';

/** Chunks of a PNG by type, those of one type joined. */
async function chunksOf(png: Blob): Promise<Map<string, Buffer>> {
  const bytes = Buffer.from(await png.arrayBuffer());
  const chunks = new Map<string, Buffer>();
  for (let at = 8; at < bytes.length; at += 12 + bytes.readUInt32BE(at)) {
    const type = bytes.toString('latin1', at + 4, at + 8);
    const data = bytes.subarray(at + 8, at + 8 + bytes.readUInt32BE(at));
    chunks.set(type, Buffer.concat([chunks.get(type) ?? Buffer.alloc(0), data]));
  }
  return chunks;
}

it('writes rows that come in parts, with their size', async () => {
  const pixels = Uint8Array.from({ length: 4 * 3 * 2 }, (_, i) => i * 10);
  const writer = new PngWriter(3, 2);
  await writer.write(pixels.subarray(0, 12));
  await writer.write(pixels.subarray(12));
  const chunks = await chunksOf(await writer.end());
  expect([...chunks.keys()]).toEqual(['IHDR', 'sRGB', 'IDAT', 'IEND']);
  const header = chunks.get('IHDR')!;
  expect([header.readUInt32BE(0), header.readUInt32BE(4), header[8], header[9]]).toEqual([3, 2, 8, 6]);
  expect([...inflateSync(chunks.get('IDAT')!)]).toEqual([0, ...pixels.subarray(0, 12), 0, ...pixels.subarray(12)]);
});

it('has the checksum of the standard: that of an empty IEND is AE 42 60 82', async () => {
  const writer = new PngWriter(1, 1);
  await writer.write(Uint8Array.of(1, 2, 3, 4));
  const bytes = new Uint8Array(await (await writer.end()).arrayBuffer());
  expect([...bytes.subarray(-4)]).toEqual([0xae, 0x42, 0x60, 0x82]);
});

it('does not end while rows are missing', async () => {
  await expect(new PngWriter(1, 2).end()).rejects.toThrow('A PNG of 2 rows got 0.');
});
