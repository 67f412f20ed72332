/** Greatest pixels per side, and in total, of a picture that is decoded. */
const SIDE = 16_384;
const PIXELS = 2 ** 27;

/** Size of a picture from its header (px); null for an unknown format. */
export function imageSize(bytes: Uint8Array): { width: number; height: number } | null {
  if (bytes.length < 30) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const tag = (at: number): string => String.fromCharCode(...bytes.subarray(at, at + 4));
  if (tag(0) === '\x89PNG') return { width: view.getUint32(16), height: view.getUint32(20) };
  if (tag(0) === 'RIFF' && tag(8) === 'WEBP') return webpSize(view, tag(12));
  if (bytes[0] === 0xff && bytes[1] === 0xd8) return jpegSize(view);
  if (tag(0).startsWith('#?')) {
    const head = new TextDecoder('latin1').decode(bytes.subarray(0, HEAD));
    const size = /^[ \t]*[-+][XY][ \t]+(\d+)[ \t]+[-+][XY][ \t]+(\d+)\s*$/m.exec(head);
    return size && { width: Number(size[2]), height: Number(size[1]) };
  }
  if (tag(0) === '\xabKTX') return { width: view.getUint32(20, true), height: Math.max(1, view.getUint32(24, true)) };
  // further formats that browsers decode, even under another format's extension
  if (tag(0) === 'GIF8') return { width: view.getUint16(6, true), height: view.getUint16(8, true) };
  if (tag(0).startsWith('BM')) {
    return { width: Math.abs(view.getInt32(18, true)), height: Math.abs(view.getInt32(22, true)) };
  }
  return tag(4) === 'ftyp' ? avifSize(view) : null;
}

/** Number of bytes at the start of a file that must contain the size. */
const HEAD = 65_536;

/** The largest of the pictures in an AVIF, each with a property `ispe`. @see ISO/IEC 23008-12, 6.5.3 */
function avifSize(view: DataView): { width: number; height: number } | null {
  let size: { width: number; height: number } | null = null;
  for (let at = 8; at + 16 <= Math.min(view.byteLength, HEAD); at++) {
    if (view.getUint32(at) !== 0x69737065) continue;
    const [width, height] = [view.getUint32(at + 8), view.getUint32(at + 12)];
    if (!size || width * height > size.width * size.height) size = { width, height };
  }
  return size;
}

/** @see RFC 9649 */
function webpSize(view: DataView, kind: string): { width: number; height: number } | null {
  if (kind === 'VP8X') {
    const side = (at: number): number => view.getUint16(at, true) + view.getUint8(at + 2) * 65_536 + 1;
    return { width: side(24), height: side(27) };
  }
  if (kind === 'VP8L') {
    const bits = view.getUint32(21, true);
    return { width: (bits & 0x3fff) + 1, height: ((bits >> 14) & 0x3fff) + 1 };
  }
  return { width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff };
}

/**
 * Bytes between segments are skipped, as in decoders.
 * @see ITU-T T.81, B.2.2: the frame header is a segment of its own, SOF0 to SOF15 without DHT, JPG and DAC
 */
function jpegSize(view: DataView): { width: number; height: number } | null {
  let at = 2;
  while (at + 9 <= view.byteLength) {
    const marker = view.getUint8(at + 1);
    // RST0 to EOI and TEM have no length; 0xFF00 is data
    const isAlone = (marker >= 0xd0 && marker <= 0xd9) || marker <= 1;
    if (view.getUint8(at) !== 0xff || marker === 0xff || isAlone) {
      at++;
      continue;
    }
    if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker)) {
      return { height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
    }
    at += 2 + view.getUint16(at + 2);
  }
  return null;
}

/** @throws Error when a picture would take too much memory once decoded */
export function checkImageSize(bytes: Uint8Array): void {
  const size = imageSize(bytes);
  if (!size) return;
  checkPixels(size.width, size.height);
}

/** Error for a picture that is not decoded, since it would take too much memory. */
export class PixelsError extends Error {}

/** @throws PixelsError when a picture has more pixels than the limit */
export function checkPixels(width: number, height: number): void {
  if (width <= SIDE && height <= SIDE && width * height <= PIXELS) return;
  throw new PixelsError(
    `its picture has ${width} × ${height} pixels; the limit is ${SIDE} a side and ${PIXELS / 2 ** 20} million in all: make it smaller.`,
  );
}
