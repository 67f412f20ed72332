import type { Texture, WebGLRenderer } from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import { colourTarget } from './colourTarget';
import { depthTarget } from './depthTarget';
import { TextureAtlas } from './TextureAtlas';
import { textureHandle } from '../../three/handles';

/** Greatest side of the atlas of cookies and variance shadow maps (texels). */
const LARGEST_COLOURS = 4096;
/** Step in which the side of an atlas that is limited in bytes grows (texels). */
const STEP = 256;

/** The two atlases: depths of shadow maps; colours of cookies, with the moments of variance shadow maps. */
export class ShadowAtlases {
  readonly depths: TextureAtlas;
  readonly colours: TextureAtlas;
  private fine = false;

  constructor(private readonly webgl: WebGLRenderer) {
    const floats = () => lacksFloatTargets(webgl) === null;
    this.depths = new TextureAtlas(
      0,
      () => (this.fine ? 5 : 3),
      (size) => depthTarget(size, this.fine),
    );
    this.colours = new TextureAtlas(
      0,
      () => (floats() ? 8 : 4),
      (size) => colourTarget(size, floats()),
    );
  }

  /** Whether depths of shadow maps have 24 bits, not 16. */
  get isFine(): boolean {
    return this.fine;
  }

  get bytes(): number {
    return this.depths.bytes + this.colours.bytes;
  }

  /** Switches the depths of shadow maps to 24 bits; the maps drawn so far are lost. */
  refine(): void {
    this.fine = true;
    this.depths.remake();
  }

  /**
   * Raises the limits of the atlases' sides, which never fall: cameras may alternate, and the largest picture decides.
   * @param depths - needed side of the shadow maps' atlas (texels)
   * @param bytes - maximum bytes of each atlas
   */
  raiseLimits(depths: number, bytes: number): void {
    this.raise(this.depths, depths, bytes);
    this.raise(this.colours, LARGEST_COLOURS, bytes);
  }

  private raise(atlas: TextureAtlas, side: number, bytes: number): void {
    const most = Math.floor(Math.sqrt(bytes / atlas.bytesPerTexel()) / STEP) * STEP;
    atlas.raiseLimit(Math.min(side, most, this.webgl.capabilities.maxTextureSize));
  }

  /** Drops the targets and the limits of both atlases. All regions must have been released. */
  clear(): void {
    this.depths.clear();
    this.colours.clear();
  }

  /** Whether a texture of the atlases is not on the GPU: nothing was drawn yet, or the context was lost. */
  get isLost(): boolean {
    return this.lacksTexture(this.depths) || this.lacksTexture(this.colours);
  }

  /** Whether an atlas has a target whose texture is not on the GPU. */
  private lacksTexture({ texture }: TextureAtlas): boolean {
    return texture !== null && textureHandle(this.webgl, texture) === undefined;
  }

  dispose(): void {
    this.depths.dispose();
    this.colours.dispose();
  }

  /** Texture of an atlas; null while nothing was ever drawn to it. @param draws - whether this frame draws to it */
  textureOf(atlas: TextureAtlas, draws: boolean): Texture | null {
    return draws || !this.lacksTexture(atlas) ? atlas.texture : null;
  }
}
