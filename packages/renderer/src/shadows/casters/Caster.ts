import type { Object3D } from 'three';
import type { CasterGeometry } from './merged/CasterGeometry';

/** One object that casts shadows, in its state at the last traversal of the scene. */
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
  /** World matrix of the caster at its last update, 16 numbers. */
  readonly matrix: Float64Array;
  /** Hash of everything that the object's shadow depends on except its matrix, see `casterSignature`. */
  signature: number;
  /** Number of the last traversal of the scene that found the object, see `ShadowCasters.walks`. */
  lastWalk: number;
  /** Object given to three's traversal, which uploads the buffers of the caster, see `casterProxy`. */
  proxy: Object3D | null;
  /** Number of the frame that last used `proxy`. */
  proxyFrame: number;
  /** Number of changes of the world matrix so far; other changes of the box are counted too. */
  matrixVersion: number;
  /** Number of changes of `signature` so far. */
  signatureVersion: number;
  signatureWalk: number;
  /** Copy of the object's triangles among the merged casters; null while the object is drawn by itself. */
  merged: MergedCaster | null;
  /** `signatureVersion` for which the caster was last queued for merging; -1 for none. */
  queuedVersion: number;
}

/** Shadow caster whose triangles lie in one buffer with those of others. */
export interface MergedCaster {
  readonly caster: Caster;
  readonly geometry: CasterGeometry;
  /** Index of the mesh (`Page` of MergedCasters.ts) that holds the triangles; `object`: index of the matrix in it. */
  readonly page: number;
  readonly object: number;
  /** First of the caster's vertex indices in the page of merged casters. */
  readonly first: number;
  /** Value of `Caster.signatureVersion` when the triangles were merged. */
  signatureVersion: number;
  /**
   * World-space boxes of the caster's clusters of triangles: centre and half sizes (m), 6 numbers each. Valid while
   * `Caster.matrixVersion` equals `matrixVersion`.
   */
  readonly boxes: Float64Array;
  /** World-space boxes of each `CLUSTERS_PER_GROUP` clusters that follow one another, 6 numbers each. */
  readonly groups: Float64Array;
  matrixVersion: number;
  /** Whether the world matrix mirrors, which reverses the winding of triangles. */
  isMirrored: boolean;
}
