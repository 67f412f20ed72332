import type { FuzzCase } from './generate';

/** What two failures must share to be the same: their first words, without numbers. */
const kindOf = (failure: string): string =>
  failure
    .split('\n')[0]
    .replaceAll(/[\d."]+/g, '')
    .slice(0, 40);

/**
 * Takes away what a failing case does not need: of text, pieces between brackets and commas; of bytes, runs.
 * @param fails - what is wrong with a case; null when nothing is
 * @param steps - most cases that are tried
 * @param seconds - after which no more are: a case that is slow is slow each time
 */
export async function minimise(
  given: FuzzCase,
  failure: string,
  fails: (given: FuzzCase) => Promise<string | null>,
  steps = 400,
  seconds = 60,
): Promise<FuzzCase> {
  const end = performance.now() + seconds * 1000;
  let { bytes } = given;
  let size = Math.ceil(bytes.length / 2);
  for (let left = steps; size >= 1 && left > 0; size = Math.floor(size / 2)) {
    for (let at = 0; at < bytes.length && left > 0 && performance.now() < end; left--) {
      const shorter = new Uint8Array([...bytes.subarray(0, at), ...bytes.subarray(at + size)]);
      const now = await fails({ ...given, bytes: shorter });
      if (now !== null && kindOf(now) === kindOf(failure)) bytes = shorter;
      else at += size;
    }
  }
  return { ...given, bytes };
}
