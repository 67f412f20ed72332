/** Share of the width for the left views, and of the height for the upper views; 0 to 1. */
export interface PaneShare {
  readonly x: number;
  readonly y: number;
}

export const halfShare: PaneShare = { x: 0.5, y: 0.5 };

/** Smallest share of the width or height that a view may have. */
export const LEAST_SHARE = 0.1;

const limited = (part: unknown): number =>
  typeof part === 'number' && Number.isFinite(part) ? Math.min(1 - LEAST_SHARE, Math.max(LEAST_SHARE, part)) : 0.5;

/** Clamps shares so that every view has some space; anything but a number becomes 0.5. */
export const limitShare = ({ x, y }: PaneShare): PaneShare => ({ x: limited(x), y: limited(y) });
