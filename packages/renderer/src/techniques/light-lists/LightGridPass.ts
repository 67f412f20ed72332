import { BINS } from '../../lights/DepthBins';
import type { Frame } from '../../frame/Frame';
import { WordTable } from '../../gpu/WordTable';
import type { LightLists } from '../../frame/LightLists';
import type { Pass, Resource } from '../../frame/Pass';

/** Data uploaded when there are no lights to list, since a texture must be bound. */
const NO_WORDS = new Uint32Array(4);
const PLAIN: LightLists = { loop: 'lightLoopClustered', defines: {} };
const WITH_TILES: LightLists = { loop: 'lightLoopClustered', defines: { FAROL_TILE_SHADOWS: '' } };

const float = new Float32Array(1);
const bits = new Int32Array(float.buffer);

/** Uploads the light grid, which the CPU computes along with the light table. Needs the light order 'by-grid'. */
export class LightGridPass implements Pass {
  readonly name = 'light lists';
  readonly reads: readonly Resource[];
  readonly writes = ['light-lists'] as const;
  private readonly masks = new WordTable(4);
  private readonly bins = new WordTable(1);

  /**
   * @param lit - 'gbuffer' if the lists light a G-buffer: the pass then also finds tiles that shadow maps leave wholly lit or
   *   dark
   */
  constructor(private readonly lit: 'gbuffer' | null = null) {
    this.reads = lit === null ? [] : [lit];
  }

  get bytes(): number {
    return this.masks.bytes + this.bins.bytes;
  }

  render(frame: Frame): void {
    if (frame.fields !== null) return this.warmUp(frame);
    const { masks, bins } = this;
    const { uniforms } = frame;
    const { bounded, firstBounded } = frame.lights;
    const grid = frame.lights.grid!;
    const words = bounded > 0 ? grid.masks : NO_WORDS;
    const rows = bounded > 0 ? Math.max(1, (grid.tilesY * grid.words) / 4) : 1;
    const width = bounded > 0 ? Math.max(1, grid.tilesX) : 1;
    const version = bounded > 0 ? grid.changes : 0;
    masks.upload(frame.webgl, words, width, rows, version);
    bins.upload(frame.webgl, grid.bins, BINS, 1, version);
    frame.uploadedBytes += masks.uploadedBytes + bins.uploadedBytes;
    uniforms.farol_gridMasks.value = masks.texture;
    uniforms.farol_gridBins.value = bins.texture;
    const sizes = uniforms.farol_grid.value;
    sizes[0] = Math.log2(grid.tileSize);
    sizes[1] = grid.tilesY;
    sizes[2] = bounded > 0 ? grid.deepWords : 0;
    sizes[3] = firstBounded;
    // the bits of an integer, passed as a float, which could not hold its value exactly
    bits[0] = grid.depthStart;
    const depth = uniforms.farol_gridDepth.value;
    depth[0] = grid.depthShift;
    depth[1] = float[0];
    depth[2] = grid.depthScale;
    if (this.lit !== null) frame.tileShadows?.findTileShadows(frame, frame.resources.get(this.lit));
    this.warmUp(frame);
  }

  warmUp(frame: Frame): void {
    const lists = this.lit === null ? PLAIN : WITH_TILES;
    frame.resources.put('light-lists', frame.fields?.makeClusters(frame) ?? lists);
  }

  dispose(): void {
    this.masks.dispose();
    this.bins.dispose();
  }
}
