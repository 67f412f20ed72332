import { type IUniform, NoBlending, type Texture, type WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import type { GBuffer } from '../../gbuffer/GBuffer';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import { gbufferUniforms, setGBufferUniforms } from '../../passes/gbuffer/gbufferUniforms';
import { wordTarget } from '../../gpu/wordTarget';
import type { MaskUniforms } from '../../lighting/maskUniforms';
import { textureHandle } from '../../three/handles';

/**
 * Side of a tile (pixels); lightLoopClustered.glsl repeats the number. A tile of the light grid holds a whole number of
 * these.
 */
const TILE = 8;
/** Side of the pixel blocks whose depths are bounded first, before those of tiles (pixels). */
const BLOCK = 4;
/** Greatest number of 32-bit words a tile, one bit a light: 512 lights. */
const MOST_WORDS = 16;
const LIGHTS_PER_WORD = 32;

/**
 * Classification of lights in each tile of the picture: those known, by the bounds of their shadow maps, to light all surfaces
 * of the tile, and those known to light none. The tile's pixels need not sample the maps of either.
 */
export class ShadowTiles {
  /** Number of the frame's maps that have bounds, see `ShadowBounds`. */
  bounded = 0;
  private readonly planes = wordTarget();
  private readonly marks = wordTarget();
  private readonly uniforms = gbufferUniforms();
  private readonly tileUniforms = {
    farol_tilePlanes: { value: this.planes.texture },
    farol_shadowBounds: { value: null } as IUniform<Texture | null>,
  };
  private readonly planePass = this.make('tile planes', 'tilePlane');
  private readonly markPass = this.make('tile shadows', 'tileShadows');
  private isCompiled = false;

  get bytes(): number {
    return !this.isCompiled ? 0 : (this.planes.width * this.planes.height + this.marks.width * this.marks.height) * 16;
  }

  /**
   * Marks the tiles of a frame. Call once its G-buffer and light grid are complete.
   * @param bounds - depth bounds of the shadow maps
   */
  render(frame: Frame, gbuffer: GBuffer, bounds: WebGLRenderTarget): void {
    const mask = frame.uniforms as unknown as MaskUniforms;
    const { lights } = frame;
    const words = Math.min(MOST_WORDS, 2 * Math.ceil(lights.grid!.count / (2 * LIGHTS_PER_WORD)));
    // tests need depth that is linear over a flat surface, so not logarithmic, and fine enough to give positions
    const linear = !frame.webgl.capabilities.logarithmicDepthBuffer && !frame.storesDistance && !frame.queue.reachesFar;
    const finds = this.bounded > 0 && lights.bounded > 0 && linear;
    mask.farol_tileShadows.value = this.marks.texture;
    mask.farol_tileShadowWords.value = finds ? words : 0;
    if (!this.isCompiled) this.compile(frame, bounds);
    if (!finds) {
      this.giveStorage(frame);
      return;
    }
    setGBufferUniforms(this.uniforms, gbuffer, frame);
    const x = Math.ceil(frame.width / TILE);
    const y = Math.ceil(frame.height / TILE);
    this.draw(frame, this.planes, this.planePass, Math.ceil(frame.width / BLOCK), Math.ceil(frame.height / BLOCK));
    this.draw(frame, this.marks, this.markPass, (x * words) / 2, y);
  }

  dispose(): void {
    this.planes.dispose();
    this.marks.dispose();
    this.planePass.dispose();
    this.markPass.dispose();
    this.isCompiled = false;
  }

  private draw(frame: Frame, target: WebGLRenderTarget, pass: FullscreenPass, width: number, height: number): void {
    if (target.width < width || target.height < height) {
      target.setSize(Math.max(target.width, width), Math.max(target.height, height));
    }
    target.viewport.set(0, 0, width, height);
    pass.drawTo(frame, target);
  }

  /**
   * Makes three create the texture of tile marks, also after a lost context: shaders bind the texture even when nothing
   * is marked.
   */
  private giveStorage(frame: Frame): void {
    if (textureHandle(frame.webgl, this.marks.texture) === undefined) frame.bind(this.marks);
  }

  private make(program: string, fragment: string): FullscreenPass {
    return new FullscreenPass({
      program,
      fragment,
      shared: [
        'farol_lightTable',
        'farol_lightCounts',
        'farol_worldAxes',
        'farol_gridMasks',
        'farol_grid',
        'farol_tileShadowWords',
      ],
      uniforms: { ...this.uniforms, ...this.tileUniforms },
      defines: { FAROL_TILE: `${TILE}` },
      blending: NoBlending,
    });
  }

  /** Compiles both programs with the first shadow map, so that no later frame hitches. */
  private compile(frame: Frame, bounds: WebGLRenderTarget): void {
    this.isCompiled = true;
    this.tileUniforms.farol_shadowBounds.value = bounds.texture;
    frame.bind(bounds);
    frame.bind(this.planes);
    this.planePass.compile(frame);
    frame.bind(this.marks);
    this.markPass.compile(frame);
  }
}
