import { BINS } from '../../lights/DepthBins';
import type { Frame } from '../../frame/Frame';
import { WordTable } from '../../gpu/WordTable';
import type { GBufferPass } from '../../gbuffer/GBufferPass';
import type { Pass, Resource } from '../../frame/Pass';
import type { GridUniforms } from './gridUniforms';

/** What is sent when there are no lights to list: a texture must be bound all the same. */
const NO_WORDS = new Uint32Array(4);

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** Brings the light grid, made on the CPU with the light table, to the GPU. */
export class LightGridPass implements Pass {
  readonly name = 'light lists';
  readonly reads: readonly Resource[];
  readonly writes = ['light-lists'] as const;
  private readonly masks = new WordTable(4);
  private readonly bins = new WordTable(1);

  /** @param gbuffer that its lists light: where shadow maps are told of, tiles of it are looked at too */
  constructor(
    private readonly uniforms: GridUniforms,
    private readonly gbuffer: GBufferPass | null = null,
  ) {
    this.reads = gbuffer === null ? [] : gbuffer.writes;
  }

  get bytes(): number {
    return this.masks.bytes + this.bins.bytes;
  }

  render(frame: Frame): void {
    const { uniforms, masks, bins } = this;
    const { grid, bounded, firstBounded } = frame.lights;
    const words = bounded > 0 ? grid.masks : NO_WORDS;
    const rows = bounded > 0 ? Math.max(1, (grid.tilesY * grid.words) / 4) : 1;
    const width = bounded > 0 ? Math.max(1, grid.tilesX) : 1;
    masks.upload(frame.webgl, words, width, rows);
    bins.upload(frame.webgl, grid.bins, BINS, 1);
    frame.uploadedBytes += masks.uploadedBytes + bins.uploadedBytes;
    uniforms.farol_gridMasks.value = masks.texture;
    uniforms.farol_gridBins.value = bins.texture;
    const sizes = uniforms.farol_grid.value;
    sizes[0] = Math.log2(grid.tileSize);
    sizes[1] = grid.tilesY;
    sizes[2] = bounded > 0 ? grid.deepWords : 0;
    sizes[3] = firstBounded;
    // the start goes as the float whose bits it is, which no float of its value could hold
    bits[0] = grid.depthStart;
    const depth = uniforms.farol_gridDepth.value;
    depth[0] = grid.depthShift;
    depth[1] = float[0];
    depth[2] = grid.depthScale;
    if (this.gbuffer !== null) frame.findTileShadows?.(this.gbuffer.gbuffer!);
  }

  dispose(): void {
    this.masks.dispose();
    this.bins.dispose();
  }
}
