import { FloatType, NearestFilter, type Texture, WebGLRenderTarget } from 'three';
import type { Frame, Preparation } from '../frame/Frame';
import { forwardTwins } from '../materials/forwardTwin';
import { FullscreenPass } from '../gpu/FullscreenPass';
import type { LightField } from './LightField';
import type { LightLists } from '../frame/LightLists';
import type { FieldDraws } from '../frame/FieldDraws';
import type { FoundLights } from '../lights/FoundLights';
import type { Pass } from '../frame/Pass';
import type { RecordSettings } from '../lighting/LightRecords';
import type { TileDepthUse } from '../lighting/lists/TileDepthUse';
import type { LightLoop } from '../materials/LightLoop';
import { fieldCount } from '../lights/lightData';
import { RECORDS_PER_ROW, TEXELS_PER_RECORD } from '../lights/lightRecord';
import { FieldArrays } from './FieldArrays';
import { FieldDepths } from './FieldDepths';
import { FieldLights } from './FieldLights';
import { FieldLists } from './FieldLists';
import { FieldOrder, fit } from './FieldOrder';
import { PackedLights } from './PackedLights';
import { type FieldSlices, SLICES } from './FieldSlices';

const TABLE_WIDTH = RECORDS_PER_ROW * TEXELS_PER_RECORD;
const CLUSTERS: LightLists = { loop: 'lightLoopSlices', defines: {} };
const sliceTwins = forwardTwins('lightLoopSlices');

/** Code that compiles the programs of passes ahead; implemented by renderer/warm-up. */
interface WarmUpCode {
  readonly WarmUp: new (frame: Frame, technique: object, name: string, passes: readonly Pass[]) => Preparation;
}

/**
 * The lights of LightFields in the frames of one renderer. The CPU does no work for single lights.
 *
 *     arrays, sent by rows ─┐
 *                           ├─> FieldLights: view space, culled ─> FieldOrder: by cells of the view ─┐
 *     textures of the GPU ──┘                                                                        │
 *     records of the CPU's lights ───────────────────────────────> fieldRecords: the light table <───┘
 *                                                                        │
 *                            FieldLists: boxes of 32 lights ─> blocks of 4 × 4 tiles ─> tiles, 1 bit a light
 *
 * Shaders still read one light table: records of fields are among those of lights with a range, after the plain point lights or,
 * if fields have spot lights, after all ("slots", in whole rows of 128). Lights without effect (no range, NaN, out of view)
 * become black lights far away. Tiled techniques read lists by tile; clustered ones lists by tile without depth, and for each of
 * 256 slices of depth the quads of 128 lights that reach it; techniques with volumes draw an icosahedron for each light;
 * multipass lighting adds all fields in one draw for each object, by lists of tiles.
 * @see Olsson and Assarsson 2011, Tiled Shading; Drobot 2017, Improved Culling for Tiled and Clustered Rendering
 */
export class LightFields implements FieldDraws {
  private readonly arrays = new FieldArrays();
  private readonly depths = new FieldDepths();
  private readonly packed = new PackedLights();
  private readonly lights = new FieldLights();
  private readonly order = new FieldOrder();
  private readonly lists = new Map<TileDepthUse, FieldLists>();
  private readonly allLists: FieldLists[] = [];
  private readonly table = new WebGLRenderTarget(TABLE_WIDTH, 1, {
    type: FloatType,
    minFilter: NearestFilter,
    magFilter: NearestFilter,
    depthBuffer: false,
  });
  private readonly uniforms = {
    farol_hostTable: { value: null as Texture | null },
    farol_fieldSpheres: { value: this.lights.target.textures[0] },
    farol_fieldEmissions: { value: this.lights.target.textures[1] },
    farol_fieldCones: { value: this.lights.target.textures[2] },
    farol_fieldOrder: { value: this.order.texture },
    farol_fieldSlots: { value: [0, 0, 0] },
  };
  private readonly records = new FullscreenPass({
    program: 'records of fields',
    fragment: 'fieldRecords',
    uniforms: this.uniforms,
  });
  isDrawn = false;
  /** Tile lists for which packed lights' programs are linked. */
  private prepared: TileDepthUse | null = null;
  count = 0;

  /** @param slices - uniforms of slices, shared with the renderer's programs */
  constructor(
    private readonly frame: Frame,
    private readonly slices: FieldSlices,
  ) {}

  get coverage(): number {
    return this.depths.coverage;
  }

  get texture(): Texture {
    return this.table.texture;
  }

  get bytes(): number {
    let bytes = this.arrays.bytes + this.lights.bytes + this.order.bytes + this.table.width * this.table.height * 16;
    for (let i = 0; i < this.allLists.length; i++) bytes += this.allLists[i].bytes;
    return bytes;
  }

  /** Collects the fields of a frame, and uploads their changes. */
  begin(): void {
    const { frame } = this;
    const { lights, camera } = frame;
    const { arrays, depths } = this;
    this.isDrawn = false;
    lights.plainSlots = true;
    this.count = 0;
    depths.begin(camera);
    for (const each of lights.fields) {
      const field = each as LightField;
      const rows = rowsOf(field);
      lights.slots += rows * 128;
      this.count += fieldCount(field);
      if (hasCones(field)) lights.plainSlots = false;
      if (field.castShadow) warnOfShadow(field);
      frame.uploadedBytes += arrays.upload(frame.webgl, field, rows);
      depths.add(field, camera);
    }
    depths.end();
    this.slices.farol_fieldSlices.value.set(depths.nearest, SLICES / depths.extent, depths.isLogarithmic ? 1 : 0);
  }

  render(): void {
    this.isDrawn = true;
    const { frame } = this;
    const { webgl } = frame;
    const target = webgl.getRenderTarget();
    const face = webgl.getActiveCubeFace();
    const level = webgl.getActiveMipmapLevel();
    this.drawTable();
    if (target === frame.target) frame.bindTarget();
    else webgl.setRenderTarget(target, face, level);
  }

  makeTiles(frame: Frame, use: TileDepthUse): void {
    const { lights } = frame;
    this.listsOf(use).draw(frame, lights.firstBounded, lights.listed, lights.plainQuads, false);
  }

  makeFieldTiles(frame: Frame): void {
    const { lights } = frame;
    this.listsOf('none').draw(frame, lights.firstSlot, lights.slots, 0, false);
  }

  makeClusters(frame: Frame): LightLists {
    const { lights } = frame;
    this.listsOf('none').draw(frame, lights.firstBounded, lights.listed, lights.plainQuads, true);
    return CLUSTERS;
  }

  /**
   * Collects the lights of a frame, with the scene's plain point lights in a field of the renderer's own, if enough of them are
   * in view, as soon as the programs for it are linked.
   * @param code - compiles the programs
   * @returns whether it did
   */
  pack(found: FoundLights, masks: RecordSettings, { WarmUp }: WarmUpCode): boolean {
    const { frame, packed } = this;
    const { camera, lights, preparation } = frame;
    frame.preparation = null;
    const use = lights.tileLists;
    if (use === null || !packed.pays(lights)) return false;
    if (this.prepared !== use) {
      if (preparation?.ready !== true) {
        frame.preparation = preparation ?? new WarmUp(frame, {}, 'tile lists', [this.passFor(use)]);
        return false;
      }
      this.prepared = use;
    }
    const field = packed.pack(found, camera);
    lights.collect(packed.rest, camera, masks);
    const { count } = field;
    lights.fields.push(field);
    lights.total += count;
    lights.singles += count;
    lights.visible += Math.round(packed.share * count);
    return true;
  }

  /** Pass that compiles, in a warm-up, the programs by which fields are drawn for tile lists. */
  private passFor(use: TileDepthUse): Pass {
    const warmUp = (frame: Frame) => {
      this.lights.warmUp(frame);
      this.order.compile(frame);
      this.records.drawTo(frame, this.table);
      this.listsOf(use).warmUp(frame);
    };
    return { name: 'light fields', reads: [], writes: [], bytes: 0, render: warmUp, dispose() {} };
  }

  twinsFor(loop: LightLoop): ReturnType<typeof forwardTwins> | undefined {
    return loop === 'lightLoopClustered' ? sliceTwins : undefined;
  }

  dispose(): void {
    this.frame.preparation = null;
    const { arrays, packed, lights, order, table, records, allLists } = this;
    for (const each of [packed, arrays, lights, order, table, records, ...allLists]) each.dispose();
    this.lists.clear();
    this.allLists.length = 0;
  }

  private drawTable(): void {
    const { frame, lights, order, records, table, uniforms } = this;
    const { slots, firstSlot, recordCount, fields, lightOrder } = frame.lights;
    const rows = slots / 128;
    lights.begin(frame, rows, this.depths);
    let row = 0;
    for (const each of fields) {
      const field = each as LightField;
      const own = rowsOf(field);
      lights.draw(frame, field, this.arrays.sourcesOf(field), row, own);
      row += own;
    }
    const sorts = lightOrder === 'by-depth';
    if (sorts) order.draw(frame, lights.target.textures[3], rows);
    else order.compile(frame);
    uniforms.farol_hostTable.value = frame.lights.table.texture;
    uniforms.farol_fieldOrder.value = sorts ? order.texture : lights.target.textures[3];
    const run = uniforms.farol_fieldSlots.value;
    run[0] = firstSlot;
    run[1] = slots;
    run[2] = sorts ? 1 : 0;
    fit(table, TABLE_WIDTH, Math.ceil((recordCount + slots) / RECORDS_PER_ROW));
    records.drawTo(frame, table);
  }

  private listsOf(use: TileDepthUse): FieldLists {
    let lists = this.lists.get(use);
    if (lists !== undefined) return lists;
    this.lists.set(use, (lists = new FieldLists(use, this.slices)));
    this.allLists.push(lists);
    return lists;
  }
}

const reported = new WeakSet<LightField>();

function warnOfShadow(field: LightField): void {
  if (reported.has(field)) return;
  reported.add(field);
  console.warn(
    `Farol: LightField "${field.name || field.uuid}" has castShadow, but its lights cast no shadows; use ` +
      `PointLights or SpotLights for those that must.`,
  );
}

/** Number of rows of 128 lights of a field, at least one, also for a field without lights. */
function rowsOf(field: LightField): number {
  return Math.max(1, Math.ceil(fieldCount(field) / 128));
}

function hasCones({ cones, textures }: LightField): boolean {
  return textures === null ? cones !== null : (textures.cone ?? null) !== null;
}
