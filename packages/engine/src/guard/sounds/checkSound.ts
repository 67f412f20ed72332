import { counted } from '../../base/counted';
import { flacSize } from './flacSize';
import { mp4Size } from './mp4Size';
import { mpegSize } from './mpegSize';
import { oggSize } from './oggSize';
import type { SoundSize } from './SoundSize';
import { wavSize } from './wavSize';

/** Maximum size of a decoded sound (bytes): 23 minutes of stereo. */
const MOST = 2 ** 29;
/** Browsers give samples as floats, of the rate that they were asked for or of their own. */
const BYTES = 4;

/** Size of a sound by its data; null for damaged files and formats other than MP3, AAC, Ogg, WAV, M4A and FLAC. */
export function soundSize(bytes: ArrayBuffer): SoundSize | null {
  const view = new DataView(bytes);
  if (view.byteLength < 16) return null;
  const tag = (at: number): string => String.fromCharCode(...new Uint8Array(bytes, at, 4));
  if (tag(0) === 'RIFF' && tag(8) === 'WAVE') return wavSize(view);
  if (tag(0) === 'OggS') return oggSize(view);
  if (tag(4) === 'ftyp') return mp4Size(view);
  // ID3 says its length in bytes of seven bits
  const isTagged = tag(0).startsWith('ID3');
  const from = isTagged ? 10 + [6, 7, 8, 9].reduce((sum, at) => sum * 128 + (view.getUint8(at) & 127), 0) : 0;
  if (from + 4 <= bytes.byteLength && tag(from) === 'fLaC') return flacSize(view, from);
  return mpegSize(view, from);
}

/**
 * Checks what a sound would take once it is decoded, before it is: browsers decode whatever it comes to.
 * @param rate - samples a second that it is decoded to
 * @returns bytes that it would take
 * @throws Error when it would be absurd memory, or when that cannot be told
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
