import type { Caster } from '../ShadowCasters';
import type { CasterGeometry } from './CasterGeometry';

/** A caster among the merged ones. */
export interface MergedCaster {
  readonly caster: Caster;
  readonly geometry: CasterGeometry;
  /** Which page it is on, and its number there. */
  readonly page: number;
  readonly object: number;
  /** Where its indices begin. */
  readonly first: number;
  /** What of the caster it was made of, see `Caster`. */
  look: number;
  /** Boxes of its clusters along the world's axes, and the place of the caster that they are of. */
  readonly boxes: Float64Array;
  /** The same round each `CLUSTERS_PER_GROUP` that follow one another. */
  readonly groups: Float64Array;
  place: number;
  isMirrored: boolean;
}
