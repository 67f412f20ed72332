import { flacFrame, flacInfo } from './flacSize';
import type { SoundSize } from './SoundSize';

const RATE_OF_OPUS = 48_000;
/**
 * Divisor for Vorbis, whose packets are short or long: counting all as long gives at most 3 times the true samples, so
 * the quotient never exceeds them.
 */
const SHORT = 3;

/** State of one logical stream of an Ogg. */
interface Stream {
  readonly channels: number;
  readonly rate: number;
  /** Number of samples in the packet that begins at a byte offset. */
  samplesAt(at: number): number;
  /** Number of samples up to the last page read. */
  samples: number;
  /** Greatest sample position in the headers of the stream's pages. */
  lastSample: number;
}

/** Samples of a packet of Opus. @see RFC 6716, 3.1 */
function opusSamples(view: DataView, at: number): number {
  const config = view.getUint8(at) >> 3;
  const milliseconds =
    config < 12 ? [10, 20, 40, 60][config & 3] : config < 16 ? [10, 20][config & 1] : [2.5, 5, 10, 20][config & 3];
  const code = view.getUint8(at) & 3;
  const count = code === 0 ? 1 : code < 3 ? 2 : at + 1 < view.byteLength ? view.getUint8(at + 1) & 63 : 0;
  return Math.min(120, milliseconds * count) * (RATE_OF_OPUS / 1000);
}

/** Makes the stream of a first packet; null when it is no sound. */
function beginStream(view: DataView, at: number): Stream | null {
  const text = (from: number, length: number): string =>
    String.fromCharCode(
      ...new Uint8Array(view.buffer, view.byteOffset + from, Math.min(length, view.byteLength - from)),
    );
  const counts = { samples: 0, lastSample: 0 };
  if (text(at, 7) === '\x01vorbis' && at + 30 <= view.byteLength) {
    const long = 1 << (view.getUint8(at + 28) >> 4);
    const rate = Math.max(1, view.getUint32(at + 12, true));
    return { ...counts, channels: view.getUint8(at + 11), rate, samplesAt: () => long / 2 / SHORT };
  }
  if (text(at, 8) === 'OpusHead' && at + 10 <= view.byteLength) {
    const samplesAt = (from: number): number => opusSamples(view, from);
    return { ...counts, channels: view.getUint8(at + 9), rate: RATE_OF_OPUS, samplesAt };
  }
  if (text(at, 5) !== '\x7fFLAC') return null;
  const info = flacInfo(view, at + 17);
  return info && { ...counts, ...info, samplesAt: (from) => flacFrame(view, from) };
}

/** Size of an Ogg file: per stream, the greater of the length in page headers and that of its packets. @see RFC 3533, 6 */
export function oggSize(view: DataView): SoundSize | null {
  const all: Stream[] = [];
  /** Open streams by serial number. */
  const streams = new Map<number, Stream>();
  const bytes = new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
  for (let at = 0; at >= 0 && at + 27 <= view.byteLength;) {
    // 'OggS'
    if (view.getUint32(at) !== 0x4f676753) {
      at = bytes.indexOf(0x4f, at + 1);
      continue;
    }
    const flags = view.getUint8(at + 5);
    const table = at + 27;
    let data = table + view.getUint8(at + 26);
    if (data > view.byteLength) break;
    const serial = view.getUint32(at + 14, true);
    const begun = (flags & 2) !== 0 ? beginStream(view, data) : null;
    if (begun) all.push(begun);
    const stream = begun ?? streams.get(serial);
    if (begun) streams.set(serial, begun);
    if (stream) {
      // -1: no packet ends on this page
      const lastSample = Number(view.getBigInt64(at + 6, true));
      stream.lastSample = Math.max(stream.lastSample, lastSample);
    }
    let isBeginning = (flags & 1) === 0;
    for (let i = table, end = data; i < end; i++) {
      const length = view.getUint8(i);
      if (isBeginning && length > 0 && data < view.byteLength && stream) stream.samples += stream.samplesAt(data);
      isBeginning = length < 255;
      data += length;
    }
    at = data;
  }
  if (all.length === 0) return null;
  const seconds = all.reduce((sum, { samples, lastSample, rate }) => sum + Math.max(samples, lastSample) / rate, 0);
  return {
    seconds,
    channels: Math.max(...all.map((each) => each.channels)),
    rate: Math.max(...all.map(({ rate }) => rate)),
  };
}
