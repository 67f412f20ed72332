/** Frames per second as a fraction of whole numbers, so that frame times do not drift. */
export interface FrameRate {
  readonly frames: number;
  readonly seconds: number;
}

/** Highest number of frames per second. */
export const FASTEST = 240;
/** Lowest number of frames per second. */
export const SLOWEST = 0.1;

/** Rates of cinema and television: those of NTSC are whole numbers times 1000/1001. @see SMPTE ST 12-1 */
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

/** The frame rate for a number: an exact one of `knownRates`, or else the number rounded to 3 decimals. */
export const rateOf = (value: number): FrameRate =>
  knownRates[String(value)] ?? { frames: Math.round(value * 1000), seconds: 1000 };

/** Time of a frame (s). */
export const timeOf = (frame: number, { frames, seconds }: FrameRate): number => (frame * seconds) / frames;

/**
 * The frames of a film between two times (s): the first is the nearest to `from`, and the last begins before `to`. At
 * least one.
 */
export function framesBetween(
  from: number,
  to: number,
  { frames, seconds }: FrameRate,
): { first: number; count: number } {
  const first = Math.round((from * frames) / seconds);
  // tolerance: a remainder under a thousandth of a frame adds no frame
  const count = Math.ceil(((to - from) * frames) / seconds - 1e-3);
  return { first, count: Math.max(1, count) };
}
