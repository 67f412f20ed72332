import type { Object3D } from 'three';
import type { CasterGeometry } from './merged/CasterGeometry';

/** One object that casts shadows, as it was when the scene was last walked. */
export interface Caster {
  readonly object: Object3D;
  /** World-space bounding sphere: centre, radius (m); radius Infinity where the object is not to be culled. */
  x: number;
  y: number;
  z: number;
  radius: number;
  /** World-space box, as `casterBox` gives it; what it holds counts only where `hasBox`. */
  readonly box: Float64Array;
  hasBox: boolean;
  /** World matrix, 16 numbers. */
  readonly matrix: Float64Array;
  /** See `casterSignature`. */
  signature: number;
  /** Last walk that met the object, see `ShadowCasters.walks`. */
  lastWalk: number;
  /** Object given to three's traversal, which uploads the buffers of the caster, see `casterProxy`. */
  proxy: Object3D | null;
  /** Frame for which `proxy` was handed out. */
  proxyFrame: number;
  /** Counts changes of the world matrix (or of what moves the box). */
  matrixVersion: number;
  /** Counts changes of the signature; and the walk that met the last. */
  signatureVersion: number;
  signatureWalk: number;
  /** The object among the merged casters, null while it is drawn by itself. */
  merged: MergedCaster | null;
  /** The `signatureVersion` that last asked to be merged, -1 for none. */
  queuedVersion: number;
}

/** A caster among the merged ones. */
export interface MergedCaster {
  readonly caster: Caster;
  readonly geometry: CasterGeometry;
  /** Index of the page that holds the triangles, and number of the object in that page. */
  readonly page: number;
  readonly object: number;
  /** First of the caster's indices in the page. */
  readonly first: number;
  /** `Caster.signatureVersion` that was merged. */
  signatureVersion: number;
  /** World-space boxes of the clusters, 6 numbers each, and the `Caster.matrixVersion` that they are of. */
  readonly boxes: Float64Array;
  /** World-space boxes of each `CLUSTERS_PER_GROUP` clusters that follow one another, 6 numbers each. */
  readonly groups: Float64Array;
  matrixVersion: number;
  /** The world matrix turns triangles the other way. */
  isMirrored: boolean;
}
