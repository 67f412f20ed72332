import { counted } from '../../base/counted';
import { readExrHeader } from '../exr/readExrHeader';
import { signatureOf } from '../signature';
import { checkPixels, imageSize, PixelsError } from './imageSize';

/** Limit on the decoded files of a library: `FREE` bytes plus `RATIO` times the size of the files. */
const FREE = 2 ** 30;
const RATIO = 32;

/**
 * @param decoded - total decoded size (bytes)
 * @param files - total file size (bytes)
 * @throws PixelsError when `decoded` exceeds the limit
 */
export function checkMemory(decoded: number, files: number): void {
  const limit = FREE + RATIO * files;
  if (decoded <= limit) return;
  const megabytes = (count: number): string => counted(Math.round(count / 1e6));
  throw new PixelsError(
    `the pictures and sounds would take ${megabytes(decoded)} MB once decoded, and ${megabytes(limit)} MB is the limit for files of so few bytes: make them smaller.`,
  );
}

/**
 * Decoded size of a picture (bytes); 0 for an unknown header.
 * @throws PixelsError for one of absurd size
 */
export function pictureMemory(bytes: Uint8Array): number {
  const said = signatureOf(bytes.slice(0, 16).buffer);
  const size = said === 'EXR' ? exrSize(bytes.slice().buffer) : imageSize(bytes);
  if (!size) return 0;
  checkPixels(size.width, size.height);
  // four channels a pixel: half floats for EXR and HDR, else bytes
  return size.width * size.height * (said === 'EXR' || said === 'HDR' ? 8 : 4);
}

function exrSize(bytes: ArrayBuffer): { width: number; height: number } | null {
  try {
    return readExrHeader(bytes);
  } catch (error) {
    if (error instanceof PixelsError) throw error;
    // a damaged picture is reported when it is decoded
    return null;
  }
}
