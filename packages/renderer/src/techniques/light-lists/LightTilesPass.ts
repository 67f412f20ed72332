import { NoBlending, Vector2, type Texture, type WebGLRenderTarget } from 'three';
import type { Frame } from '../../frame/Frame';
import { fitTarget } from '../../gpu/fitTarget';
import { FullscreenPass } from '../../gpu/FullscreenPass';
import type { LightLists } from '../../frame/LightLists';
import type { Pass, Resource } from '../../frame/Pass';
import type { TileDepthUse } from '../../lighting/lists/TileDepthUse';
import { fitGrids, setTiles } from '../../lighting/lists/listGrids';
import { TILE_SHIFT } from '../../lighting/lists/tileUniforms';
import { setUnprojectUniforms, unprojectUniforms } from '../../gpu/unprojectUniforms';
import { wordTarget } from '../../gpu/wordTarget';
import { textureHandle } from '../../three/handles';

const LIGHTS_PER_QUAD = 128;
/**
 * Share of its range in which quality 'lite' lists a plain point light: farther away its light is at most 1.1% of that at half
 * of the range.
 */
const LITE_REACH = 0.95;
/** Side of the blocks whose depths are bounded first (pixels). */
const BLOCK = 4;
/** Shared uniforms of the pass, without the list textures, which it writes and so must not read. */
const SHARED = ['farol_lightTable', 'farol_lightCounts', 'farol_tiles', 'farol_tileRun', 'farol_tileMask'];
const DEFINES = {
  none: {},
  bounds: { FAROL_DEPTH: '1' },
  slices: { FAROL_DEPTH: '2' },
} as const satisfies Record<TileDepthUse, object>;
const LISTS: LightLists = { loop: 'lightLoopTiled', defines: {} };

/** Program and the integer target that it draws to. */
interface Step {
  readonly pass: FullscreenPass;
  readonly target: WebGLRenderTarget;
}

/**
 * Light lists of the screen's tiles, one bit a light, made on the GPU without compute: blocks of 4 × 4 tiles test all lights,
 * tiles test the lights that their block kept, and a summary marks the quads (128 lights) that are not empty. A list has room
 * for every light.
 * @see Olsson and Assarsson 2011, Tiled Shading; Harada 2012, A 2.5D Culling for Forward+
 */
export class LightTilesPass implements Pass {
  readonly name = 'light lists';
  readonly reads: readonly Resource[];
  readonly writes = ['light-lists'] as const;
  private readonly uniforms = {
    ...unprojectUniforms(),
    farol_size: { value: new Vector2() },
    farol_beyond: { value: 1e38 },
    farol_plainReach: { value: 1 },
    farol_coarseMask: { value: null as Texture | null },
    farol_tileDepth: { value: null as Texture | null },
    farol_sceneDepth: { value: null as Texture | null },
    farol_blocks: { value: null as Texture | null },
  };
  private readonly blocks = this.step('tile depth blocks', 'tileDepthBlocks');
  private readonly depths = this.step('tile depths', 'tileDepth');
  private readonly coarse = this.step('coarse light lists', 'tileMask', { FAROL_COARSE: '' });
  private readonly fine: Step;
  private readonly summary = this.step('light list summary', 'tileSummary');
  private readonly steps: readonly Step[];
  private isCompiled = false;

  constructor(private readonly use: TileDepthUse) {
    this.reads = use === 'none' ? [] : ['scene-depth'];
    this.fine = this.step('light lists', 'tileMask', DEFINES[use]);
    this.steps = [this.blocks, this.depths, this.coarse, this.fine, this.summary];
  }

  get bytes(): number {
    return this.steps.reduce((sum, { target }) => sum + target.width * target.height * 16, 0);
  }

  render(frame: Frame): void {
    frame.resources.put('light-lists', LISTS);
    frame.lights.tileLists = this.use;
    if (frame.fields !== null) return frame.fields.makeTiles(frame, this.use);
    const { lights, width, height } = frame;
    const x = Math.ceil(width / (1 << TILE_SHIFT));
    const y = Math.ceil(height / (1 << TILE_SHIFT));
    const quads = Math.max(1, Math.ceil(lights.bounded / LIGHTS_PER_QUAD));
    const pages = Math.ceil(quads / 128);
    this.setUniforms(frame, x, y, quads);
    const shift = frame.uniforms.farol_tiles.value[0];
    if (!this.isCompiled) this.compile(frame);
    this.giveStorage(frame);
    if (lights.bounded === 0) return;
    if (this.use !== 'none') {
      fitTarget(this.blocks.target, Math.ceil(width / BLOCK), Math.ceil(height / BLOCK));
      draw(frame, this.blocks);
      fitTarget(this.depths.target, x, y);
      draw(frame, this.depths);
    }
    fitGrids(this.coarse.target, Math.ceil(x / 4), Math.ceil(y / 4), quads, shift);
    draw(frame, this.coarse);
    fitGrids(this.fine.target, x, y, quads, shift);
    draw(frame, this.fine);
    // lists of one quad need no summary
    if (quads === 1) return;
    fitGrids(this.summary.target, x, y, pages, pages > 1 ? shift : 0);
    draw(frame, this.summary);
  }

  dispose(): void {
    for (const { pass, target } of this.steps) {
      pass.dispose();
      target.dispose();
    }
    this.isCompiled = false;
  }

  private setUniforms(frame: Frame, x: number, y: number, quads: number): void {
    const { uniforms: own } = this;
    const { uniforms, queue } = frame;
    setTiles(uniforms.farol_tiles.value, x, y, quads);
    const run = uniforms.farol_tileRun.value;
    run[0] = frame.lights.firstBounded;
    run[1] = frame.lights.bounded;
    run[2] = Math.ceil(quads / 128);
    run[3] = frame.lights.plainQuads;
    uniforms.farol_tileMask.value = this.fine.target.texture;
    uniforms.farol_tileSummary.value = this.summary.target.texture;
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    setUnprojectUniforms(own, frame.camera, frame.webgl);
    own.farol_size.value.set(frame.width, frame.height);
    own.farol_beyond.value = queue.reachesFar ? Math.max(-1e30, queue.farthest) : 1e38;
    own.farol_plainReach.value = frame.isLite ? LITE_REACH : 1.0001;
    own.farol_coarseMask.value = this.coarse.target.texture;
    own.farol_tileDepth.value = this.depths.target.texture;
    own.farol_blocks.value = this.blocks.target.texture;
    own.farol_sceneDepth.value = this.use === 'none' ? null : frame.resources.get('scene-depth');
  }

  /** Creates the textures of lists that a frame does not fill, also after a lost context, since shaders bind them. */
  private giveStorage(frame: Frame): void {
    for (const { target } of [this.fine, this.summary]) {
      if (textureHandle(frame.webgl, target.texture) === undefined) frame.bind(target);
    }
  }

  /** Compiles all programs ahead, each for its kind of target, so that a later frame with more lights does not wait. */
  private compile(frame: Frame): void {
    this.isCompiled = true;
    this.giveStorage(frame);
    for (const { pass, target } of this.steps) {
      frame.bind(target);
      if (this.use !== 'none' || (pass !== this.blocks.pass && pass !== this.depths.pass)) pass.compile(frame);
    }
  }

  private step(program: string, fragment: string, defines: Record<string, string> = {}): Step {
    const { uniforms } = this;
    const options = { program, fragment, uniforms, shared: SHARED, defines, blending: NoBlending };
    return { pass: new FullscreenPass(options), target: wordTarget() };
  }
}

function draw(frame: Frame, { pass, target }: Step): void {
  pass.drawTo(frame, target);
}
