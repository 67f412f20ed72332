import type { Light } from 'three';

/** A light, or an object above one. */
type Placed = NonNullable<Light['parent']>;

/** Reads properties of many lights in a row ahead of their use, so that their memory is in the cache. */
export interface LightFetcher {
  /**
   * Reads what an update of the matrices of some lights needs.
   * @returns index after the last object looked at; the length of the list if that is short
   */
  fetchPlaces(objects: readonly Placed[], first: number): number;
  /** Reads colours and intensities of some lights. @returns as `fetchPlaces` */
  fetchEmissions(lights: readonly Light[], first: number): number;
  /** Sentence for `FarolInfo.hint` about a number of lights that are objects of their own; null for none. */
  hintFor(singles: number): string | null;
}

/** Holder of the LightFetcher: null until the code of light lists, which brings it, is fetched. */
export const fetching: { fetcher: LightFetcher | null } = { fetcher: null };
