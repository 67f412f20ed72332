/** Parts of the width and the height of the picture that the views at the left and above take, from 0 to 1. */
export interface PaneShare {
  readonly x: number;
  readonly y: number;
}

export const halfShare: PaneShare = { x: 0.5, y: 0.5 };

/** Least that a view keeps of the picture. */
export const LEAST_SHARE = 0.1;

const limited = (part: unknown): number =>
  typeof part === 'number' && Number.isFinite(part) ? Math.min(1 - LEAST_SHARE, Math.max(LEAST_SHARE, part)) : 0.5;

/** A share with room for every view; what is no number is a half. */
export const limitShare = ({ x, y }: PaneShare): PaneShare => ({ x: limited(x), y: limited(y) });
