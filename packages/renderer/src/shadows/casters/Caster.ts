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
  /** World-space box, by `casterBox`; valid only if `hasBox`. */
  readonly box: Float64Array;
  hasBox: boolean;
  /** World matrix, 16 numbers. */
  readonly matrix: Float64Array;
  /** Hash of the state that the shadow depends on, besides the matrix; see `casterSignature`. */
  signature: number;
  /** Last walk over the scene that met the object, see `ShadowCasters.walks`. */
  lastWalk: number;
  /** Object given to three's traversal, which uploads the buffers of the caster, see `casterProxy`. */
  proxy: Object3D | null;
  /** Frame for which `proxy` was handed out. */
  proxyFrame: number;
  /** Counts changes of the world matrix, and other changes of the box. */
  matrixVersion: number;
  /** Counts changes of the signature; `signatureWalk` is the walk that met the last change. */
  signatureVersion: number;
  signatureWalk: number;
  /** Entry of the object among the merged casters; null while the object is drawn by itself. */
  merged: MergedCaster | null;
  /** `signatureVersion` for which the caster last asked to be merged; -1 for none. */
  queuedVersion: number;
}

/** A caster among the merged ones. */
export interface MergedCaster {
  readonly caster: Caster;
  readonly geometry: CasterGeometry;
  /** Index of the page that holds the triangles, and number of the object in that page. */
  readonly page: number;
  readonly object: number;
  /** First of the caster's vertex indices in the page. */
  readonly first: number;
  /** `Caster.signatureVersion` at the time of merging. */
  signatureVersion: number;
  /** World-space boxes of the clusters, 6 numbers each; found at `Caster.matrixVersion` = `matrixVersion`. */
  readonly boxes: Float64Array;
  /** World-space boxes of each `CLUSTERS_PER_GROUP` clusters that follow one another, 6 numbers each. */
  readonly groups: Float64Array;
  matrixVersion: number;
  /** Whether the world matrix mirrors, which turns triangles the other way round. */
  isMirrored: boolean;
}
