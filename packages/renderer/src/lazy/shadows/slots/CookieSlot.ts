import type { CubeTexture, Texture } from 'three';
import type { AtlasTenant } from '../atlas/TileAtlas';
import type { Tile } from '../atlas/TilePacker';

/** Texels a side that an image has in the atlas at most. */
const LARGEST = 1024;

/** Texels round each face of a cube; as in lightShadow.glsl. */
export const COOKIE_BORDER = 1;

type Sized = { width?: number; height?: number; videoWidth?: number; videoHeight?: number };

/** An image that lights throw, in the atlas of colours: one for all lights that share the texture. */
export class CookieSlot implements AtlasTenant {
  readonly isCube: boolean;
  readonly coverage = 1;
  wantedWidth = 1;
  wantedHeight = 1;
  tile: Tile | null = null;
  faceWidth = 0;
  faceHeight = 0;
  halvings = 0;
  drawn = false;
  /** Frame in which a light last threw it. */
  used = 0;
  private version = -1;

  constructor(readonly texture: Texture | CubeTexture) {
    this.isCube = (texture as CubeTexture).isCubeTexture === true;
  }

  /** Follows the texture: what it holds now is to be drawn when that changed. */
  follow(): void {
    const { texture } = this;
    const image = (this.isCube ? (texture as CubeTexture).images[0] : texture.image) as
      (Sized & { image?: Sized }) | undefined;
    const source = image?.image ?? image;
    const width = source?.videoWidth ?? source?.width ?? 1;
    const height = source?.videoHeight ?? source?.height ?? 1;
    this.wantedWidth = Math.min(LARGEST, Math.max(1, width));
    this.wantedHeight = this.isCube ? this.wantedWidth : Math.min(LARGEST, Math.max(1, height));
    const isLive = (texture as Texture & { isVideoTexture?: boolean }).isVideoTexture || texture.isRenderTargetTexture;
    if (isLive || this.version !== texture.version) this.drawn = false;
    this.version = texture.version;
  }

  borderOf(): number {
    return COOKIE_BORDER;
  }

  place(tile: Tile, faceWidth: number, faceHeight: number): void {
    this.tile = tile;
    this.faceWidth = faceWidth;
    this.faceHeight = faceHeight;
    this.drawn = false;
  }
}
