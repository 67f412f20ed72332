import { crc32 } from '../../guard/zip/crc32';
import type { Picture } from './pictures';

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];

/** A PNG chunk: length, type, data, and CRC of type and data. */
async function chunk(type: string, data: Uint8Array): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  for (let i = 0; i < 4; i++) bytes[4 + i] = type.charCodeAt(i);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, await crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

/**
 * Encodes an image as PNG. A canvas would premultiply alpha and lose the colours of transparent pixels: filtering shows
 * those colours at the edges of cut-outs.
 * @see PNG (ISO/IEC 15948), 5 and 10
 */
export async function encodePng({ width, height, data }: Picture): Promise<Uint8Array<ArrayBuffer>> {
  const stride = width * 4;
  const rows = new Uint8Array((stride + 1) * height);
  for (let y = 0; y < height; y++) {
    const at = y * (stride + 1);
    // PNG filter 1 (difference from the previous texel) compresses better
    rows[at] = 1;
    for (let x = 0; x < stride; x++) {
      rows[at + 1 + x] = data[y * stride + x] - (x < 4 ? 0 : data[y * stride + x - 4]);
    }
  }
  const packed = new Blob([rows]).stream().pipeThrough(new CompressionStream('deflate'));
  const head = new Uint8Array(13);
  const view = new DataView(head.buffer);
  view.setUint32(0, width);
  view.setUint32(4, height);
  // 8 bits per channel; colour type 6, which is red, green, blue and alpha
  head.set([8, 6], 8);
  const parts = [
    new Uint8Array(SIGNATURE),
    await chunk('IHDR', head),
    await chunk('IDAT', new Uint8Array(await new Response(packed).arrayBuffer())),
    await chunk('IEND', new Uint8Array()),
  ];
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
