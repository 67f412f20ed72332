import type { SoundSize } from './SoundSize';

/** Bit rates (kbit/s) by index: MPEG 1 layers 1 to 3, MPEG 2 layer 1, MPEG 2 layers 2 and 3. */
const RATES = [
  [0, 32, 64, 96, 128, 160, 192, 224, 256, 288, 320, 352, 384, 416, 448],
  [0, 32, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 384],
  [0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320],
  [0, 32, 48, 56, 64, 80, 96, 112, 128, 144, 160, 176, 192, 224, 256],
  [0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160],
];
const SAMPLE_RATES = [44_100, 48_000, 32_000];
const AAC_RATES = [96_000, 88_200, 64_000, 48_000, 44_100, 32_000, 24_000, 22_050, 16_000, 12_000, 11_025, 8000, 7350];

interface Frame {
  /** Length of the MPEG frame (bytes). */
  readonly length: number;
  readonly samples: number;
  readonly rate: number;
  readonly channels: number;
}

/** A frame of MPEG audio, layers 1 to 3. @see ISO/IEC 11172-3, 2.4.1 */
function mpegFrame(view: DataView, at: number): Frame | null {
  const version = (view.getUint8(at + 1) >> 3) & 3;
  const layer = 4 - ((view.getUint8(at + 1) >> 1) & 3);
  const second = view.getUint8(at + 2);
  const rateIndex = (second >> 2) & 3;
  if (version === 1 || layer === 4 || rateIndex === 3) return null;
  const isFirst = version === 3;
  const kilobits = RATES[isFirst ? layer - 1 : layer === 1 ? 3 : 4][second >> 4];
  if (!kilobits) return null;
  const rate = SAMPLE_RATES[rateIndex] / (isFirst ? 1 : version === 2 ? 2 : 4);
  const samples = layer === 1 ? 384 : layer === 3 && !isFirst ? 576 : 1152;
  const padding = ((second >> 1) & 1) * (layer === 1 ? 4 : 1);
  return {
    length: Math.floor((samples / 8) * ((kilobits * 1000) / rate)) + padding,
    samples,
    rate,
    channels: view.getUint8(at + 3) >> 6 === 3 ? 1 : 2,
  };
}

/** A frame of AAC in ADTS; with SBR, twice the samples at twice the rate. @see ISO/IEC 13818-7, 6.2 */
function aacFrame(view: DataView, at: number): Frame | null {
  const rate = AAC_RATES[(view.getUint8(at + 2) >> 2) & 15];
  const length = ((view.getUint16(at + 3) & 0x3ff) << 3) | (view.getUint8(at + 5) >> 5);
  const blocks = 1 + (view.getUint8(at + 6) & 3);
  return rate && length >= 7 ? { length, samples: blocks * 1024, rate, channels: 2 } : null;
}

/** Size of an MP3, or of AAC in ADTS, by all its frames; bytes between frames are skipped, as in decoders. */
export function mpegSize(view: DataView, from: number): SoundSize | null {
  let seconds = 0;
  let rate = 0;
  let channels = 0;
  for (let at = from; at + 7 <= view.byteLength;) {
    const isSync = (view.getUint16(at) & 0xffe0) === 0xffe0;
    const isAac = (view.getUint8(at + 1) & 0xf6) === 0xf0;
    const frame = isSync ? (isAac ? aacFrame(view, at) : mpegFrame(view, at)) : null;
    if (frame) {
      seconds += frame.samples / frame.rate;
      rate = Math.max(rate, frame.rate);
      channels = Math.max(channels, frame.channels);
    }
    at += frame?.length ?? 1;
  }
  return seconds > 0 ? { seconds, channels, rate } : null;
}
