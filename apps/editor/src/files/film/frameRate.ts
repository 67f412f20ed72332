/** Frames a second as a fraction of whole numbers, so that the time of no frame drifts. */
export interface FrameRate {
  readonly frames: number;
  readonly seconds: number;
}

/** Greatest number of frames a second. */
export const FASTEST = 240;
/** Smallest number of frames a second. */
export const SLOWEST = 0.1;

/** Rates of cinema and television: those of NTSC are 1000/1001 of whole ones. @see SMPTE ST 12-1 */
export const knownRates: Readonly<Record<string, FrameRate>> = {
  '23.976': { frames: 24_000, seconds: 1001 },
  '24': { frames: 24, seconds: 1 },
  '25': { frames: 25, seconds: 1 },
  '29.97': { frames: 30_000, seconds: 1001 },
  '30': { frames: 30, seconds: 1 },
  '50': { frames: 50, seconds: 1 },
  '59.94': { frames: 60_000, seconds: 1001 },
  '60': { frames: 60, seconds: 1 },
};

/** The rate of a number: one of `knownRates` where it is that, to 3 decimals else. */
export const rateOf = (value: number): FrameRate =>
  knownRates[String(value)] ?? { frames: Math.round(value * 1000), seconds: 1000 };

/** Time of a frame (s). */
export const timeOf = (frame: number, { frames, seconds }: FrameRate): number => (frame * seconds) / frames;

/**
 * The frames of a film that lasts from one time to another (s): the first is the nearest to `from`, and the last begins
 * before `to`. One at least.
 */
export function framesBetween(
  from: number,
  to: number,
  { frames, seconds }: FrameRate,
): { first: number; count: number } {
  const first = Math.round((from * frames) / seconds);
  // a thousandth of a frame is none
  const count = Math.ceil(((to - from) * frames) / seconds - 1e-3);
  return { first, count: Math.max(1, count) };
}
