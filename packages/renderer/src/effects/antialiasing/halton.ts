/**
 * The Halton low-discrepancy sequence.
 * @param index - from 1
 * @param base - a prime
 * @returns above 0, below 1
 * @see Halton 1964, Algorithm 247: Radical-inverse quasi-random point sequence
 */
export function halton(index: number, base: number): number {
  let result = 0;
  let fraction = 1 / base;
  for (let i = index; i > 0; i = Math.floor(i / base)) {
    result += (i % base) * fraction;
    fraction /= base;
  }
  return result;
}
