import { counted } from '../../base/counted';
import { flacSize } from './flacSize';
import { mp4Size } from './mp4Size';
import { mpegSize } from './mpegSize';
import { oggSize } from './oggSize';
import type { SoundSize } from './SoundSize';
import { wavSize } from './wavSize';

/** Maximum size of a decoded sound (bytes): 23 minutes of stereo. */
const MOST = 2 ** 29;
/** Bytes of a decoded sample: browsers decode to 32-bit floats, at the requested rate or the file's own. */
const BYTES = 4;

/** Size of a sound by its data; null for a damaged file, or none of MP3, AAC, Ogg, WAV, M4A and FLAC. */
export function soundSize(bytes: ArrayBuffer): SoundSize | null {
  const view = new DataView(bytes);
  if (view.byteLength < 16) return null;
  const tag = (at: number): string => String.fromCharCode(...new Uint8Array(bytes, at, 4));
  if (tag(0) === 'RIFF' && tag(8) === 'WAVE') return wavSize(view);
  if (tag(0) === 'OggS') return oggSize(view);
  if (tag(4) === 'ftyp') return mp4Size(view);
  // the length of an ID3 tag is stored as 7 bits per byte
  const isTagged = tag(0).startsWith('ID3');
  const from = isTagged ? 10 + [6, 7, 8, 9].reduce((sum, at) => sum * 128 + (view.getUint8(at) & 127), 0) : 0;
  if (from + 4 <= bytes.byteLength && tag(from) === 'fLaC') return flacSize(view, from);
  return mpegSize(view, from);
}

/**
 * Checks the decoded size of a sound beforehand, since browsers decode sounds of any length.
 * @param rate - sample rate of the decoded sound (Hz)
 * @returns decoded size (bytes)
 * @throws Error when the size is too great or unknown
 */
export function checkSound(bytes: ArrayBuffer, rate: number): number {
  const size = soundSize(bytes);
  if (!size) throw new Error('it cannot be decoded: convert it to MP3, Ogg or WAV.');
  const { seconds, channels } = size;
  const memory = seconds * channels * Math.max(rate, size.rate) * BYTES;
  if (memory <= MOST) return memory;
  const megabytes = (count: number): string => counted(Math.round(count / 1e6));
  throw new Error(
    `it would take ${megabytes(memory)} MB once it is decoded (${counted(Math.round(seconds / 60))} minutes), and ${megabytes(MOST)} MB is the limit: make it shorter.`,
  );
}
