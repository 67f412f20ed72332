import {
  FloatType,
  NearestFilter,
  NoBlending,
  RedIntegerFormat,
  type Texture,
  UnsignedIntType,
  Vector2,
  WebGLRenderTarget,
} from 'three';
import type { Frame } from '../frame/Frame';
import { fitTarget } from '../gpu/fitTarget';
import { FullscreenPass } from '../gpu/FullscreenPass';
import { setUnprojectUniforms, unprojectUniforms } from '../gpu/unprojectUniforms';
import { wordTarget } from '../gpu/wordTarget';
import type { TileDepthUse } from '../lighting/lists/TileDepthUse';
import { fitGrids, setTiles } from '../lighting/lists/listGrids';
import { TILE_SHIFT } from '../lighting/lists/tileUniforms';
import { fit } from './FieldOrder';
import { type FieldSlices, SLICES } from './FieldSlices';

const LIGHTS_PER_QUAD = 128;
/** Side of the blocks whose depths are bounded first (pixels). */
const BLOCK = 4;
const SHARED = ['farol_lightTable', 'farol_lightCounts', 'farol_tiles', 'farol_tileRun'];
const DEFINES = {
  none: {},
  bounds: { FAROL_DEPTH: '1' },
  slices: { FAROL_DEPTH: '2' },
} as const satisfies Record<TileDepthUse, object>;

interface Step {
  readonly pass: FullscreenPass;
  readonly target: WebGLRenderTarget;
}

/**
 * Light lists of the screen's tiles, in the form of LightTilesPass, for lights of fields sorted by cells: each 32 lights have a
 * bounding box, by which blocks of 4 × 4 tiles skip most lights without reading them, with depths also by the block's depth
 * range.
 */
export class FieldLists {
  private readonly passUniforms = {
    ...unprojectUniforms(),
    farol_fieldSlices: {} as FieldSlices['farol_fieldSlices'],
    farol_size: { value: new Vector2() },
    farol_beyond: { value: 1e38 },
    farol_plainReach: { value: 1.0001 },
    farol_coarseMask: { value: null as Texture | null },
    farol_tileDepth: { value: null as Texture | null },
    farol_fieldTileDepth: { value: null as Texture | null },
    farol_sceneDepth: { value: null as Texture | null },
    farol_blocks: { value: null as Texture | null },
    farol_tileMask: { value: null as Texture | null },
    farol_boxLows: { value: null as Texture | null },
    farol_boxHighs: { value: null as Texture | null },
  };
  private readonly boxes: Step = {
    pass: this.pass('boxes of lights', 'fieldBoxes'),
    target: new WebGLRenderTarget(4, 1, {
      count: 2,
      type: FloatType,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthBuffer: false,
    }),
  };
  private readonly depthBlocks = this.step('tile depth blocks', 'tileDepthBlocks');
  private readonly depths = this.step('tile depths', 'tileDepth');
  private readonly blocks: Step;
  private readonly fine: Step;
  private readonly summary = this.step('light list summary', 'tileSummary');
  private readonly slices: Step = {
    pass: this.pass('light slices', 'fieldSlices'),
    target: wordTarget(RedIntegerFormat, UnsignedIntType, 'R32UI'),
  };

  /** All passes except `slices`; their targets have four words of 32 bits a texel. */
  private readonly steps: readonly Step[];

  constructor(
    private readonly use: TileDepthUse,
    private readonly shared: FieldSlices,
  ) {
    this.passUniforms.farol_fieldSlices = shared.farol_fieldSlices;
    this.blocks = this.step('blocks of light lists', 'fieldBlocks', use === 'none' ? {} : { FAROL_BLOCK_DEPTH: '' });
    this.fine = this.step('light lists', 'tileMask', DEFINES[use]);
    this.steps = [this.boxes, this.depthBlocks, this.depths, this.blocks, this.fine, this.summary];
  }

  get bytes(): number {
    const { boxes, slices, steps } = this;
    let bytes = slices.target.width * slices.target.height * 4 + boxes.target.width * boxes.target.height * 16;
    // counts `boxes` again, since its target has two attachments of 16 bytes a texel
    for (let i = 0; i < steps.length; i++) bytes += steps[i].target.width * steps[i].target.height * 16;
    return bytes;
  }

  /**
   * Draws the lists.
   * @param first - first record of the listed lights
   * @param count - number of listed lights, at least 1
   * @param plainQuads - number of quads, from the first on, with only plain point lights
   * @param sliced - whether to draw the quads of each slice of depth too
   */
  draw(frame: Frame, first: number, count: number, plainQuads: number, sliced: boolean): void {
    const x = Math.ceil(frame.width / (1 << TILE_SHIFT));
    const y = Math.ceil(frame.height / (1 << TILE_SHIFT));
    const quads = Math.ceil(count / LIGHTS_PER_QUAD);
    const pages = Math.ceil(quads / 128);
    this.setUniforms(frame, x, y, quads);
    const shift = frame.uniforms.farol_tiles.value[0];
    const { uniforms } = frame;
    const run = uniforms.farol_tileRun.value;
    run[0] = first;
    run[1] = count;
    run[2] = pages;
    run[3] = plainQuads;
    fit(this.boxes.target, 4, quads);
    draw(frame, this.boxes);
    if (this.use !== 'none') {
      fitTarget(this.depthBlocks.target, Math.ceil(frame.width / BLOCK), Math.ceil(frame.height / BLOCK));
      draw(frame, this.depthBlocks);
      fitTarget(this.depths.target, x, y);
      draw(frame, this.depths);
    }
    fitGrids(this.blocks.target, Math.ceil(x / 4), Math.ceil(y / 4), quads, shift);
    draw(frame, this.blocks);
    fitGrids(this.fine.target, x, y, quads, shift);
    draw(frame, this.fine);
    // sized in any case, since light loops bind the texture
    fitGrids(this.summary.target, x, y, pages, pages > 1 ? shift : 0);
    draw(frame, this.summary);
    uniforms.farol_tileMask.value = this.fine.target.texture;
    uniforms.farol_tileSummary.value = this.summary.target.texture;
    if (!sliced) return;
    fit(this.slices.target, SLICES, Math.ceil(quads / 32));
    draw(frame, this.slices);
    this.shared.farol_sliceQuads.value = this.slices.target.texture;
  }

  /** Draws for a warm-up, which compiles the programs of lists that are not sliced and draws nothing. */
  warmUp(frame: Frame): void {
    for (const step of this.steps)
      if (this.use !== 'none' || (step !== this.depthBlocks && step !== this.depths)) draw(frame, step);
  }

  dispose(): void {
    for (const { pass, target } of [...this.steps, this.slices]) {
      pass.dispose();
      target.dispose();
    }
  }

  private setUniforms(frame: Frame, x: number, y: number, quads: number): void {
    const { passUniforms } = this;
    const { uniforms, queue } = frame;
    setTiles(uniforms.farol_tiles.value, x, y, quads);
    uniforms.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    setUnprojectUniforms(passUniforms, frame.camera, frame.webgl);
    passUniforms.farol_size.value.set(frame.width, frame.height);
    passUniforms.farol_beyond.value = queue.reachesFar ? Math.max(-1e30, queue.farthest) : 1e38;
    passUniforms.farol_coarseMask.value = this.blocks.target.texture;
    passUniforms.farol_tileDepth.value = passUniforms.farol_fieldTileDepth.value = this.depths.target.texture;
    passUniforms.farol_blocks.value = this.depthBlocks.target.texture;
    passUniforms.farol_tileMask.value = this.fine.target.texture;
    passUniforms.farol_boxLows.value = this.boxes.target.textures[0];
    passUniforms.farol_boxHighs.value = this.boxes.target.textures[1];
    passUniforms.farol_sceneDepth.value = this.use === 'none' ? null : frame.resources.get('scene-depth');
  }

  private step(program: string, fragment: string, defines: Record<string, string> = {}): Step {
    return { pass: this.pass(program, fragment, defines), target: wordTarget() };
  }

  private pass(program: string, fragment: string, defines: Record<string, string> = {}): FullscreenPass {
    const { passUniforms: uniforms } = this;
    return new FullscreenPass({ program, fragment, uniforms, shared: SHARED, defines, blending: NoBlending });
  }
}

function draw(frame: Frame, { pass, target }: Step): void {
  pass.drawTo(frame, target);
}
