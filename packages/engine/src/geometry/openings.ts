/** A hole in a wall (m): its extent along the wall from the middle, and upwards from the floor. */
export interface Opening {
  readonly from: number;
  readonly to: number;
  readonly bottom: number;
  readonly top: number;
}

/** Smallest width (m) of wall at the sides of a hole and above it. */
const RIM = 0.05;

/** Requested size and position of a hole (m). */
export interface OpeningSize {
  readonly width: number;
  readonly height: number;
  /** Height of the hole's bottom above the floor (m); 0 for a door. */
  readonly sill: number;
  /** Distance from the wall's middle to the hole's middle (m). */
  readonly offset: number;
}

/**
 * A hole, fitted into a wall of a length and a height (m): moved along the wall, lowered and narrowed as needed; null
 * when none fits.
 */
export function fitOpening(asked: OpeningSize, length: number, height: number): Opening | null {
  const width = Math.min(asked.width, length - 2 * RIM);
  const top = Math.min(asked.sill + asked.height, height - RIM);
  const bottom = Math.min(asked.sill, top);
  if (width <= 0 || top - bottom <= 0) return null;
  const furthest = (length - width) / 2 - RIM;
  const middle = Math.min(furthest, Math.max(-furthest, asked.offset));
  return { from: middle - width / 2, to: middle + width / 2, bottom, top };
}

/** Whether a hole contains the point of a wall that is `along` (m) from its middle and `up` (m) above the floor. */
export const isInOpening = ({ from, to, bottom, top }: Opening, along: number, up: number): boolean =>
  along > from && along < to && up > bottom && up < top;
