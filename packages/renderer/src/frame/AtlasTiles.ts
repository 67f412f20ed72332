import type { Camera, Light, Texture } from 'three';

/** A shadow map's face, or an image, in its atlas. */
export interface AtlasTile {
  readonly light: Light | null;
  readonly kind: 'face' | 'cascade' | 'map' | 'image' | 'profile';
  /** Index of the face or cascade, from 0; `count`: their number. */
  readonly index: number;
  readonly count: number;
  /** Rectangle of the tile in the atlas (texels). */
  readonly region: Readonly<{ x: number; y: number; width: number; height: number }>;
  /** Camera of a shadow map; null for images. */
  readonly camera: Camera | null;
}

/** An atlas of a frame, and its regions in use. */
export interface AtlasTiles {
  /** Texture of the atlas; null while nothing is drawn. */
  readonly texture: Texture | null;
  /** Values in the texture: depths for a shadow sampler; moments of depths; colours. */
  readonly holds: 'depths' | 'moments' | 'colours';
  /** Side of the atlas (texels). */
  readonly size: number;
  readonly tiles: readonly AtlasTile[];
}
