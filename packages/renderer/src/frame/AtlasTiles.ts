import type { Camera, Light, Texture } from 'three';

/** A shadow map's face, or an image, in its atlas. */
export interface AtlasTile {
  readonly light: Light | null;
  readonly kind: 'face' | 'cascade' | 'map' | 'image' | 'profile';
  /** Index of the face or cascade, from 0, and their number. */
  readonly index: number;
  readonly count: number;
  /** Rectangle (texels). */
  readonly region: Readonly<{ x: number; y: number; width: number; height: number }>;
  /** Camera of a shadow map; null for images. */
  readonly camera: Camera | null;
}

/** Contents of an atlas in a frame. */
export interface AtlasTiles {
  /** Null while nothing is drawn. */
  readonly texture: Texture | null;
  /** Contents: depths for a comparing sampler; moments of depths; colours. */
  readonly holds: 'depths' | 'moments' | 'colours';
  /** Texels a side. */
  readonly size: number;
  readonly tiles: readonly AtlasTile[];
}
