import { FileError } from './FileError';
import { counted } from '../base/counted';

/** Limits of the size of unpacked data. */
export const unpackLimits = {
  /** Unpacked size (bytes) up to which the user is not asked. */
  free: 64 * 2 ** 20,
  /** Unpacked size as a multiple of the packed size up to which the user is not asked. */
  ratio: 20,
  /** Unpacked size (bytes) above which data are refused. */
  maxBytes: 2 ** 30,
  /** Greatest number of files in a ZIP. */
  entries: 10_000,
} as const;

/** Question to the user before packed data become large. */
export interface UnpackQuestion {
  /** Size of the packed data (bytes). */
  readonly packed: number;
  /** Unpacked size (bytes); for a stream, the size so far. */
  readonly unpacked: number;
}

/** Returns whether to unpack large data. They are refused without such a function. */
export type MayUnpack = (sizes: UnpackQuestion) => boolean | Promise<boolean>;

const megabytes = (bytes: number): string =>
  bytes < 1e6 ? `${counted(Math.ceil(bytes / 1e3))} kB` : `${counted(Math.round(bytes / 1e6))} MB`;

/** Packed and unpacked size as text for questions and messages: 'from 390 kB to 400 MB'. */
export const sizesText = ({ packed, unpacked }: UnpackQuestion): string =>
  `from ${megabytes(packed)} to ${megabytes(unpacked)}`;

/**
 * Checks the unpacked size of data against the limits, and asks when it is large.
 * @throws FileError beyond the limit, or without `mayUnpack`; an AbortError when `mayUnpack` returns false
 */
export async function checkUnpacking(sizes: UnpackQuestion, mayUnpack?: MayUnpack): Promise<void> {
  const { packed, unpacked } = sizes;
  if (unpacked <= unpackLimits.free || (unpacked <= packed * unpackLimits.ratio && unpacked <= unpackLimits.maxBytes))
    return;
  if (unpacked > unpackLimits.maxBytes || !mayUnpack) {
    const limit = unpacked > unpackLimits.maxBytes ? unpackLimits.maxBytes : unpackLimits.free;
    const problem = `The file would grow ${sizesText(sizes)} when it is unpacked, and ${megabytes(limit)} is the limit: it is damaged, or was made to do harm.`;
    throw new FileError([{ path: '', problem }]);
  }
  if (!(await mayUnpack(sizes))) throw new DOMException('The file was not unpacked.', 'AbortError');
}

/**
 * Unpacks bytes, and checks the size while it grows.
 * @param exact - expected unpacked size (bytes); any size within the limits when absent
 * @param most - greatest unpacked size (bytes), in place of the limits
 * @throws FileError, or AbortError: see `checkUnpacking`; TypeError when the data are damaged or cut short; RangeError
 *   when the size exceeds `most`
 */
export async function unpack(
  bytes: Uint8Array<ArrayBuffer>,
  format: CompressionFormat,
  { mayUnpack, exact, most = exact }: { mayUnpack?: MayUnpack; exact?: number; most?: number } = {},
): Promise<Uint8Array<ArrayBuffer>> {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream(format)).getReader();
  const parts: Uint8Array[] = [];
  let length = 0;
  let isAsked = false;
  try {
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      parts.push(value);
      length += value.length;
      if (most !== undefined) {
        if (length > most) throw new RangeError('it unpacks to more than it may');
        continue;
      }
      const sizes = { packed: bytes.length, unpacked: length };
      const isLarge = length > unpackLimits.free && length > bytes.length * unpackLimits.ratio;
      if (length > unpackLimits.maxBytes || (isLarge && !isAsked)) {
        await checkUnpacking(sizes, mayUnpack);
        isAsked = true;
      }
    }
  } catch (error) {
    reader.cancel().catch(() => {});
    throw error;
  }
  if (exact !== undefined && length !== exact) throw new TypeError('it unpacks to less than its size says');
  const whole = new Uint8Array(length);
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
