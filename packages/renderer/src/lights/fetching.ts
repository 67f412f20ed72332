import type { FoundLights, Placed } from './FoundLights';

/** Reads thousands of lights fast: their cache misses overlap, and each value is read once. */
export interface LightReader {
  /**
   * Adds plain point lights (see `readPoint`) to those found, and updates their matrices: children, from `first` on, of an
   * object whose world matrix is the identity. Ends at the first other child, or the first that the camera's layers do not see.
   * @param mask - layers of the camera
   * @returns index of that child
   */
  readPoints(parent: Placed, first: number, mask: number, found: FoundLights): number;
  /** Sentence for `FarolInfo.hint` about a number of light objects; null for none. */
  hintFor(singles: number): string | null;
}

/** Holder of the LightReader: null until the code of light lists, which sets it, is loaded. */
export const fetching: { reader: LightReader | null } = { reader: null };
