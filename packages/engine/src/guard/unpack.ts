import { FileError } from './FileError';
import { counted } from '../base/counted';

/** Limits of the size of unpacked data. */
export const unpackLimits = {
  /** Unpacked bytes up to which the user is not asked. */
  free: 64 * 2 ** 20,
  /** Unpacked size as a multiple of the packed size up to which the user is not asked. */
  ratio: 20,
  /** Unpacked bytes beyond which data are refused. */
  maxBytes: 2 ** 30,
  /** Greatest number of files in a ZIP. */
  entries: 10_000,
} as const;

/** Question to the user before packed data become large. */
export interface UnpackQuestion {
  /** Size of the packed data (bytes). */
  readonly packed: number;
  /** Unpacked bytes; of a stream, those so far. */
  readonly unpacked: number;
}

/** Whether to go on with data that become large. They are refused when nobody can be asked. */
export type MayUnpack = (sizes: UnpackQuestion) => boolean | Promise<boolean>;

const megabytes = (bytes: number): string =>
  bytes < 1e6 ? `${counted(Math.ceil(bytes / 1e3))} kB` : `${counted(Math.round(bytes / 1e6))} MB`;

/** 'from 390 kB to 400 MB', for questions and messages. */
export const sizesText = ({ packed, unpacked }: UnpackQuestion): string =>
  `from ${megabytes(packed)} to ${megabytes(unpacked)}`;

/**
 * Checks what packed data become, once they are more than is free.
 * @throws FileError beyond the limit, or when nobody can be asked; an AbortError when the answer is no
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
 * Unpacks bytes, and counts what comes out while it does.
 * @param exact - bytes that must come out; any number within the limits when absent
 * @param most - bytes that may come out, in place of the limits
 * @throws FileError, or AbortError: see `checkUnpacking`; TypeError when the data are damaged or cut short; RangeError when
 * more comes out than may
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
