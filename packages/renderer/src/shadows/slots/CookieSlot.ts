import type { CubeTexture, Texture } from 'three';
import { AtlasMap } from '../atlas/AtlasMap';
import { AtlasPlacement } from '../atlas/AtlasPlacement';
import { LEVEL_BORDER } from '../atlas/mipmapBlock';
import type { AtlasTenant } from '../atlas/TextureAtlas';
import { imageFilter, imageLevels } from './imageFilter';

/** Greatest side of a cookie in the atlas (texels); larger textures are copied smaller. */
const LARGEST = 1024;

type Sized = { width?: number; height?: number; videoWidth?: number; videoHeight?: number };

/** Cookie (texture that lights project) or photometric profile in the atlas of colours, shared by all lights with that texture. */
export class CookieSlot implements AtlasTenant {
  readonly isCube: boolean;
  readonly coverage = 1;
  /** Region of the texture's copy; written by the atlas. */
  readonly placement = new AtlasPlacement();
  /** State of the copy in the atlas. */
  readonly map = new AtlasMap();
  wantedWidth = 1;
  wantedHeight = 1;
  /** Number of mipmap levels in the atlas; undefined for a profile. */
  levels: number | undefined = undefined;
  /** Filtering of the texture, see `imageFilter`; 0 for a profile. */
  filter = 0;
  /** Index of the sampler for the texture itself; -1 when shaders sample the copy. Written by `ImageSamplers`. */
  sampler = -1;
  /** Width of the texture (texels). */
  textureWidth = 1;
  /** Number of the last frame in which a light used the texture. */
  lastLit = 0;
  /** Version of the texture at the last `follow`; -1 before the first. */
  private version = -1;

  /** @param isProfile - the texture is a photometric profile */
  constructor(
    readonly texture: Texture | CubeTexture,
    readonly isProfile = false,
  ) {
    this.isCube = (texture as CubeTexture).isCubeTexture === true;
  }

  /** Marks the copy as stale if the texture has changed since. @param mostAnisotropy - greatest anisotropy of the device */
  follow(mostAnisotropy: number): void {
    const { texture } = this;
    const image = (this.isCube ? (texture as CubeTexture).images[0] : texture.image) as
      | (Sized & { image?: Sized })
      | undefined;
    const source = image?.image ?? image;
    const width = source?.videoWidth ?? source?.width ?? 1;
    const height = source?.videoHeight ?? source?.height ?? 1;
    this.wantedWidth = Math.min(LARGEST, Math.max(1, width));
    // a profile repeats its first row after the last, at 360°
    const rows = this.isProfile && height > 1 ? height + 1 : height;
    this.wantedHeight = this.isCube ? this.wantedWidth : Math.min(LARGEST, Math.max(1, rows));
    if (!this.isProfile) this.followFilter(Math.max(1, width), Math.max(1, height), mostAnisotropy);
    const isLive = (texture as Texture & { isVideoTexture?: boolean }).isVideoTexture || texture.isRenderTargetTexture;
    if (isLive || this.version !== texture.version) this.map.change();
    this.version = texture.version;
  }

  private followFilter(width: number, height: number, mostAnisotropy: number): void {
    const { texture } = this;
    this.textureWidth = width;
    this.levels = imageLevels(texture, width, height, this.wantedWidth);
    this.filter = imageFilter(texture, this.levels, mostAnisotropy);
  }

  /** Whether shaders can sample the cookie: from the texture itself, or from its copy once that has a region. */
  get isThere(): boolean {
    return this.sampler >= 0 || this.placement.region !== null;
  }

  borderOf(): number {
    return LEVEL_BORDER;
  }
}
