import type { SoundSize } from './SoundSize';

/** CRC-8 of the header of a frame. @see RFC 9639, 9.1.8 */
function crc8(view: DataView, from: number, to: number): number {
  let crc = 0;
  for (let at = from; at < to; at++) {
    crc ^= view.getUint8(at);
    for (let bit = 0; bit < 8; bit++) crc = crc & 0x80 ? ((crc << 1) ^ 7) & 0xff : crc << 1;
  }
  return crc;
}

/** Samples per channel of the frame at a byte offset; 0 when there is no frame. @see RFC 9639, 9.1 */
export function flacFrame(view: DataView, at: number): number {
  if (at + 6 > view.byteLength || (view.getUint16(at) & 0xfffe) !== 0xfff8) return 0;
  const [sizeCode, rateCode] = [view.getUint8(at + 2) >> 4, view.getUint8(at + 2) & 15];
  // the frame number is coded like UTF-8: the first byte gives the number of further bytes
  const first = view.getUint8(at + 4);
  const following = first < 0x80 ? 0 : Math.clz32(~(first << 24)) - 1;
  let end = at + 5 + Math.max(0, following);
  const sizeAt = end;
  end += sizeCode === 6 ? 1 : sizeCode === 7 ? 2 : 0;
  end += rateCode === 12 ? 1 : rateCode === 13 || rateCode === 14 ? 2 : 0;
  if (sizeCode === 0 || end >= view.byteLength || crc8(view, at, end) !== view.getUint8(end)) return 0;
  if (sizeCode === 1) return 192;
  if (sizeCode <= 5) return 576 << (sizeCode - 2);
  if (sizeCode === 6) return view.getUint8(sizeAt) + 1;
  return sizeCode === 7 ? view.getUint16(sizeAt) + 1 : 256 << (sizeCode - 8);
}

/** Channels and rate of a STREAMINFO. @param at - byte offset of its data */
export function flacInfo(view: DataView, at: number): { channels: number; rate: number } | null {
  if (at + 18 > view.byteLength) return null;
  const bits = view.getUint32(at + 10);
  return { rate: Math.max(1, bits >>> 12), channels: ((bits >> 9) & 7) + 1 };
}

/** Size of a FLAC by all its frames; the length in the header is ignored. @param from - byte offset of 'fLaC' */
export function flacSize(view: DataView, from: number): SoundSize | null {
  const info = flacInfo(view, from + 8);
  if (!info) return null;
  const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
  let samples = 0;
  for (let at = bytes.indexOf(0xff, from + 42); at >= 0; at = bytes.indexOf(0xff, at + 1))
    samples += flacFrame(view, at);
  return { ...info, seconds: samples / info.rate };
}
