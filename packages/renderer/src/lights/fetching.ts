import type { Light } from 'three';
import type { FoundLights, Placed } from './FoundLights';

/** Reads lights by the thousand: what their values take of memory is waited for together, and read once. */
export interface LightReader {
  /**
   * Adds plain point lights (see `readPoint`) to those found, and updates their matrices: children, from `first` on, of an object
   * whose world matrix is the identity. Ends at the first child that is none, or that the camera's layers do not see.
   * @param mask - layers of the camera
   * @returns index of that child; `first` if it is that
   */
  readPoints(parent: Placed, first: number, mask: number, found: FoundLights): number;
  /**
   * Reads colours and intensities of some lights ahead of their use.
   * @returns index after the last one; the length of the list if that is short
   */
  fetchEmissions(lights: readonly Light[], first: number): number;
  /** Sentence for `FarolInfo.hint` about a number of lights that are objects of their own; null for none. */
  hintFor(singles: number): string | null;
}

/** Holder of the LightReader: null until the code of light lists, which brings it, is fetched. */
export const fetching: { reader: LightReader | null } = { reader: null };
