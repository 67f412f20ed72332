/** Pixels a side, and in all, beyond which a picture is not decoded. */
const SIDE = 16_384;
const PIXELS = 2 ** 27;

/** What a picture's first bytes say of its size (px); null where they say nothing. */
export function imageSize(bytes: Uint8Array): { width: number; height: number } | null {
  if (bytes.length < 30) return null;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const tag = (at: number): string => String.fromCharCode(...bytes.subarray(at, at + 4));
  if (tag(0) === '\x89PNG') return { width: view.getUint32(16), height: view.getUint32(20) };
  if (tag(0) === 'RIFF' && tag(8) === 'WEBP') return webpSize(view, tag(12));
  if (bytes[0] === 0xff && bytes[1] === 0xd8) return jpegSize(view);
  if (tag(0).startsWith('#?')) {
    const head = new TextDecoder('latin1').decode(bytes.subarray(0, 4096));
    const size = /^[-+][XY] +(\d+) +[-+][XY] +(\d+)\s*$/m.exec(head);
    return size && { width: Number(size[2]), height: Number(size[1]) };
  }
  return null;
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

/** @see ITU-T T.81, B.2.2: the frame header is a segment of its own, SOF0 to SOF15 without DHT, JPG and DAC */
function jpegSize(view: DataView): { width: number; height: number } | null {
  let at = 2;
  while (at + 9 <= view.byteLength) {
    if (view.getUint8(at) !== 0xff) return null;
    const marker = view.getUint8(at + 1);
    if (marker >= 0xc0 && marker <= 0xcf && ![0xc4, 0xc8, 0xcc].includes(marker)) {
      return { height: view.getUint16(at + 5), width: view.getUint16(at + 7) };
    }
    at += marker === 0xff ? 1 : 2 + view.getUint16(at + 2);
  }
  return null;
}

/** @throws Error when a picture would take absurd memory once it is decoded */
export function checkImageSize(bytes: Uint8Array): void {
  const size = imageSize(bytes);
  if (!size) return;
  checkPixels(size.width, size.height);
}

/** @throws Error when a picture of so many pixels would take absurd memory */
export function checkPixels(width: number, height: number): void {
  if (width <= SIDE && height <= SIDE && width * height <= PIXELS) return;
  throw new Error(
    `its picture has ${width} × ${height} pixels, and ${SIDE} a side, ${PIXELS / 2 ** 20} million in all, is the limit: make it smaller.`,
  );
}
