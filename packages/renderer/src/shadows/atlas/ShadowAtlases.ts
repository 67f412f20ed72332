import type { Texture, WebGLRenderer } from 'three';
import { lacksFloatTargets } from '../../gpu/checkDevice';
import { colourTarget } from './colourTarget';
import { depthTarget } from './depthTarget';
import { TextureAtlas } from './TextureAtlas';
import { textureHandle } from '../../three/handles';

/** Greatest side of the atlas of cookies and variance shadow maps (texels). */
const LARGEST_COLOURS = 4096;

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
      Math.min(LARGEST_COLOURS, webgl.capabilities.maxTextureSize),
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

  /** The texture of an atlas; null while nothing is drawn, now or before. @param draws - whether it is drawn to now */
  textureOf(atlas: TextureAtlas, draws: boolean): Texture | null {
    return draws || !this.lacksTexture(atlas) ? atlas.texture : null;
  }
}
