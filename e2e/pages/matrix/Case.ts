import type { Object3D, Texture } from 'three';

/** Resources that cases share, made once a page. */
export interface Kit {
  /** Radiance of a room, as PMREM. */
  readonly environment: Texture;
}

/** One thing to draw, about 1.3 units wide round the origin, before a lit wall. */
export type MakeCase = (kit: Kit) => Object3D;

/** Cases by name. A new one is a line. */
export type Cases = Record<string, MakeCase>;
