import { type Camera, type Light, type Matrix4, Vector3, type WebGLRenderer } from 'three';
import { DataTable } from '../gpu/DataTable';
import type { LightGrid } from '../lights/LightGrid';
import {
  emissionDecay,
  FLOATS_PER_RECORD,
  LIGHT,
  NO_LIGHT,
  RECORDS_PER_ROW,
  TEXELS_PER_RECORD,
} from '../lights/lightRecord';
import type { PlainPoints } from '../lights/plainPoints';
import type { TileDepthUse } from './lists/TileDepthUse';
import type { PictureSize } from '../lights/PictureSize';
import { VisibleLights } from '../lights/VisibleLights';
import { type LightMasks, LightRecords, type RecordSettings } from './LightRecords';

/** Number of lights in a quad of tile lists: four 32-bit words, one bit for each light. */
export const QUAD = 128;

const position = new Vector3();

/**
 * Order of the lights with a range in the table: spheres before cones; near to far by their centres; or by their ranks in the
 * light grid, which is then computed too. The code of the last two is late code.
 */
export type LightOrder = 'by-volume' | 'by-depth' | 'by-grid';

/** Sorts the lights of a table: sets its `order` and `bounded`. Used for every order but 'by-volume'. */
export type RankLights = (lights: LightTable, camera: Camera, size: PictureSize) => void;

/**
 * The visible lights of a frame as one float texture, in view space, a record each, in runs: directional, local without a range,
 * local with a range in a `LightOrder`. Limited only by the texture's size (RECORDS_PER_ROW × MAX_TEXTURE_SIZE records). A light
 * is identified by three's `Light`, its index in `boundeds`, and its record; `order` maps the record of a light with a range to
 * its index.
 */
export class LightTable extends VisibleLights {
  readonly table = new DataTable(RECORDS_PER_ROW * TEXELS_PER_RECORD);
  /**
   * Index in `boundeds` of the light of each record, counted from `firstBounded`. Only the first `bounded` are valid.
   */
  order: Uint32Array = new Uint32Array(64);
  /** Number of lights with a range that are not plain point lights. */
  extendedCount = 0;
  /** Number of records of lights with a range, including empty ones of a grid. */
  bounded = 0;
  /** Number of quads (128 records), from the first on, that hold only plain point lights; set by a write 'by-depth'. */
  plainQuads = 0;
  /** Tile masks and depth bins, up to date after a write 'by-grid'; null before the first such write. */
  grid: LightGrid | null = null;
  /** First mask record (shadow map, cookie, layers of a light) in the light table. */
  firstMask = 0;
  /**
   * Number of records that the GPU inserts for the lights of light fields, from `firstSlot` on, into the texture that shaders
   * read. 0 without fields: shaders then read `table` itself.
   */
  slots = 0;
  /** Whether all lights of LightFields are plain point lights, without cones. */
  plainSlots = true;
  firstSlot = 0;
  /** Number of records of `table`. */
  recordCount = 0;
  /** Use of depths by the tile lists of the last frame; null if it had none. */
  tileLists: TileDepthUse | null = null;
  /** Order of the lights with a range in the last write. */
  lightOrder: LightOrder = 'by-volume';
  declare protected settings: RecordSettings | null;
  private orders: Uint32Array = new Uint32Array(64);
  private readonly records = new LightRecords(this.table);

  /** Number of directional lights. */
  get directional(): number {
    return this.directionals.length;
  }

  /** Number of local lights without a range. */
  get unbounded(): number {
    return this.unboundeds.length;
  }

  /** Record of the first local light with a range. */
  get firstBounded(): number {
    return this.directional + this.unbounded;
  }

  /** Number of records of lights with a range in the texture that shaders read, lights of fields included. */
  get listed(): number {
    return this.bounded + this.slots;
  }

  override collect(
    lights: readonly Light[],
    camera: Camera,
    settings: RecordSettings,
    points: PlainPoints | null = null,
  ): void {
    super.collect(lights, camera, settings, points);
    this.bounded = this.boundeds.length;
  }

  /**
   * Fills the table with the collected lights.
   * @param masks - masks of lights; null for none
   * @param rank - function that ranks lights for the order; null for 'by-volume'
   */
  write(
    camera: Camera,
    lightOrder: LightOrder,
    size: PictureSize,
    masks: LightMasks | null = null,
    rank: RankLights | null = null,
  ): void {
    const view = camera.matrixWorldInverse;
    this.lightOrder = lightOrder;
    if (rank === null) this.rankByVolume();
    else rank(this, camera, size);
    this.placeSlots(lightOrder);
    this.firstMask = this.firstBounded + this.bounded;
    const firstExtension = this.firstMask + (masks?.records ?? 0);
    const { records, table } = this;
    // reserves the worst case: an extension record for every light
    table.reserve((firstExtension + this.firstBounded + this.bounded) * FLOATS_PER_RECORD);
    records.begin(masks, this.firstMask, this.settings, this.slots);
    let record = 0;
    for (const light of this.directionals) records.writeDirectional(record++, light, view);
    for (const light of this.unboundeds) {
      const { x, y, z } = position.setFromMatrixPosition(light.matrixWorld).applyMatrix4(view);
      records.writeLocal(record++, light, x, y, z, 0, view);
    }
    this.extendedCount = this.plainSlots ? 0 : this.slots;
    for (let k = 0; k < this.bounded; k++) this.writeBounded(record++, this.order[k], view);
    masks?.write(table, this.firstMask, camera);
    this.recordCount = firstExtension + records.extensions;
    table.used(this.recordCount * FLOATS_PER_RECORD);
  }

  /** Uploads the records that have changed. */
  upload(webgl: WebGLRenderer): void {
    this.table.upload(webgl);
  }

  /** Bytes uploaded by the last `upload`. */
  get uploadedBytes(): number {
    return this.table.uploadedBytes;
  }

  /** Bytes of the textures. */
  get bytes(): number {
    return this.table.bytes;
  }

  dispose(): void {
    this.table.dispose();
  }

  /** Makes `order` an array of at least `count` numbers, if it is shorter. @returns `order` */
  makeOrder(count: number): Uint32Array {
    if (this.orders.length < count) this.orders = new Uint32Array(count * 2);
    return (this.order = this.orders);
  }

  private rankByVolume(): void {
    const { cones } = this;
    const count = (this.bounded = this.boundeds.length);
    const order = this.makeOrder(count);
    let sphere = 0;
    let cone = this.sphereCount;
    for (let i = 0; i < count; i++) order[cones[i * 4 + 3] > -1 ? cone++ : sphere++] = i;
  }

  /**
   * Sets `firstSlot`, the first record of light fields' lights: plain ones follow the quads of plain point lights, others the
   * last light.
   */
  private placeSlots(lightOrder: LightOrder): void {
    const { slots, plainQuads, bounded } = this;
    let before = bounded;
    if (slots > 0 && lightOrder === 'by-depth') {
      if (this.plainSlots) {
        before = Math.min(bounded, plainQuads * QUAD);
        this.plainQuads = Math.ceil((before + slots) / QUAD);
      } else if (bounded < plainQuads * QUAD) this.plainQuads--;
    }
    this.firstSlot = this.firstBounded + before;
  }

  /** @param i - index of a light in `boundeds`, or NO_LIGHT */
  private writeBounded(record: number, i: number, view: Matrix4): void {
    const { spheres, emissions, table } = this;
    const to = record * FLOATS_PER_RECORD;
    const at = i * 4;
    if (i === NO_LIGHT) {
      // radius 0: an empty record lights nothing, even in loops that do not read tile lists
      table.set4(to + LIGHT.sphere, 0, 0, 0, 1);
      table.set4(to + LIGHT.emission, 0, 0, 0, emissionDecay(2, true));
    } else if (emissions[at + 3] >= 0) {
      table.set4(to + LIGHT.sphere, spheres[at], spheres[at + 1], spheres[at + 2], spheres[at + 3]);
      table.set4(to + LIGHT.emission, emissions[at], emissions[at + 1], emissions[at + 2], emissions[at + 3]);
    } else {
      const x = spheres[at];
      const y = spheres[at + 1];
      const z = spheres[at + 2];
      if (!this.records.writeLocal(record, this.boundeds[i], x, y, z, spheres[at + 3], view)) this.extendedCount++;
    }
  }
}
