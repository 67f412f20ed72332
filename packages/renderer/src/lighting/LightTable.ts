import type {
  Camera,
  DirectionalLight,
  HemisphereLight,
  Light,
  Matrix4,
  PerspectiveCamera,
  PointLight,
  SpotLight,
  WebGLRenderer,
} from 'three';
import { Vector3 } from 'three';
import { AmbientSum } from '../lights/AmbientSum';
import { DataTable } from '../gpu/DataTable';
import { FLOATS_PER_RECORD, RECORDS_PER_ROW } from '../lights/lightRecord';
import { FiniteLights } from '../lights/FiniteLights';
import { isBlackLight } from '../lights/isBlackLight';
import { lightAxis } from '../lights/lightAxis';
import { lightRange } from '../lights/lightRange';
import { type LightMasks, LightRecords } from './LightRecords';
import { viewFrustumPlanes } from '../lights/viewFrustumPlanes';
import { sphereOutsidePlanes } from '../lights/sphereOutsidePlanes';
import { coneBoundingSphere } from '../lights/coneBoundingSphere';
import { NO_LIGHT } from '../lights/DepthBins';
import { DepthOrder } from '../lights/DepthOrder';
import { LightGrid } from '../lights/LightGrid';
import type { LightLayers } from '../lazy/shadows/LightLayers';
import { cookieOf } from '../lights/lightCookie';

/** Cones wider than this are drawn and culled as spheres (rad). */
const WIDEST_CONE = 1.05;

const position = new Vector3();
const axis = new Vector3();
const planes = new Float64Array(24);
const coneSphere = new Float64Array(4);

/**
 * How the lights with a range lie in the table: spheres before cones, near to far by their centres, or by the ranks of the
 * light grid, which is then made.
 */
export type LightOrder = 'by-volume' | 'by-depth' | 'by-grid';

/** What is drawn to: the grid's tiles are cut from it. */
export interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/**
 * All managed lights of a frame as one float texture, in view space, in runs: directional, local without a range, local
 * with a range, the last in a `LightOrder`. Local lights that cannot reach what the camera sees are left out. No limit but the texture's size
 * (RECORDS_PER_ROW × MAX_TEXTURE_SIZE records).
 */
export class LightTable {
  readonly table = new DataTable(RECORDS_PER_ROW * (FLOATS_PER_RECORD / 4));
  /** Directional lights, unbounded local lights, sphere lights, cone lights. */
  directional = 0;
  unbounded = 0;
  spheres = 0;
  cones = 0;
  /** Managed lights in the scene, and those kept for this frame (ambient and hemisphere lights included). */
  total = 0;
  visible = 0;
  /** Constant and three slopes (x, y, z of the view-space normal) of the ambient irradiance, 4 × RGB. */
  readonly ambient: Float32Array;
  /** View-space sphere [x, y, z, r] (m) of each local light with a range, r its range; in the order of `rank`. */
  bounds = new Float64Array(64);
  /** View-space [axis to the light, cos cutoff] of the same lights; cos -1 for a sphere. */
  axes = new Float64Array(64);
  /** Record of a light with a range, less `firstBounded`, to its place in `bounds`. Only the first `bounded`. */
  rank: Uint32Array = new Uint32Array(64);
  /** Lights with a range that are not point lights as three has them. */
  others = 0;
  /** Records of lights with a range; a grid may leave some empty. */
  bounded = 0;
  /** Estimate of how many lights with a range lie over a pixel, whatever its depth. */
  coverage = 0;
  /** Quads of 128 records, from the first on, that hold only point lights as three has them; after an update 'by-depth'. */
  plainQuads = 0;
  /** Tile masks and depth bins, up to date after an update 'by-grid'. */
  readonly grid = new LightGrid();
  /** Lights of the frame that may have a mask: they are no plain point lights. */
  readonly masked: Light[] = [];
  /** Which lights do not reach all objects. */
  layers: LightLayers | null = null;
  /** True when lights that cast shadows have them. */
  shadows = false;
  /** Record of the first mask. */
  firstMask = 0;
  /** The lights of the frame that are kept: directional ones, local ones without a range, and those with one. */
  readonly directionals: DirectionalLight[] = [];
  readonly unboundeds: Light[] = [];
  readonly boundeds: Light[] = [];
  /** How many of `boundeds` are of this frame. */
  private kept = 0;
  /** Of each of `boundeds`: colour times intensity and decay if a plain point light, else decay -1. */
  private plain = new Float64Array(64);
  private readonly depthOrder = new DepthOrder();
  private volumes: Uint32Array = new Uint32Array(64);
  private readonly finite = new FiniteLights();
  private readonly ambientSum = new AmbientSum();
  private readonly records: LightRecords;
  private projection: ArrayLike<number> = [];

  constructor() {
    this.ambient = this.ambientSum.values;
    this.records = new LightRecords(this.table, (light) => this.mayBeMasked(light));
  }

  /** Record of the first local light with a range. */
  get firstBounded(): number {
    return this.directional + this.unbounded;
  }

  /**
   * Sorts out the lights of a frame. World matrices must be up to date.
   * @param lights the managed lights that are visible to the camera's layers
   * @param camera gives view space; its frustum drops lights that reach nothing it sees
   */
  collect(lights: readonly Light[], camera: Camera): void {
    viewFrustumPlanes(camera.projectionMatrix.elements, planes);
    this.coverage = 0;
    this.projection = camera.projectionMatrix.elements;
    this.classify(lights, camera.matrixWorldInverse);
    this.directional = this.directionals.length;
    this.unbounded = this.unboundeds.length;
    if (this.boundeds.length > this.kept) this.boundeds.length = this.kept;
    this.visible += this.directional + this.unbounded + this.boundeds.length;
    this.bounded = this.boundeds.length;
  }

  /**
   * Fills the table with what was collected.
   * @param size of what is drawn to (pixels)
   */
  write(camera: Camera, order: LightOrder, size: PictureSize, masks: LightMasks | null = null): void {
    const view = camera.matrixWorldInverse;
    this.setRanks(order, camera, size);
    this.firstMask = this.firstBounded + this.bounded;
    const firstExtension = this.firstMask + (masks?.records ?? 0);
    const { records, table } = this;
    // every light may need an extension record
    table.reserve((firstExtension + this.firstBounded + this.bounded) * FLOATS_PER_RECORD);
    records.begin(masks, this.firstMask);
    let record = 0;
    for (const light of this.directionals) records.writeDirectional(record++, light, view);
    for (const light of this.unboundeds) {
      const { x, y, z } = position.setFromMatrixPosition(light.matrixWorld).applyMatrix4(view);
      records.writeLocal(record++, light, x, y, z, view);
    }
    for (let k = 0; k < this.bounded; k++) this.writeBounded(record++, k, view);
    masks?.write(table, this.firstMask, camera);
    table.used((firstExtension + records.extensions) * FLOATS_PER_RECORD);
  }

  /** Says which record each light with a range gets. */
  private setRanks(order: LightOrder, camera: Camera, size: PictureSize): void {
    const count = this.boundeds.length;
    const { bounds, axes, grid } = this;
    this.bounded = count;
    if (order === 'by-grid') {
      const { near, far } = camera as PerspectiveCamera;
      grid.update(
        count,
        bounds,
        camera.projectionMatrix.elements,
        near,
        far,
        size.width,
        size.height,
        this.cones > 0 ? axes : null,
      );
      this.rank = grid.order;
      this.bounded = grid.count;
    } else if (order === 'by-depth') {
      this.rank = this.volumes = this.plainFirst(count, this.depthOrder.sort(count, bounds, 4, 2));
    } else {
      if (this.volumes.length < count) this.volumes = new Uint32Array(count * 2);
      this.rank = this.volumes;
      let sphere = 0;
      let cone = this.spheres;
      for (let i = 0; i < count; i++) this.rank[axes[i * 4 + 3] > -1 ? cone++ : sphere++] = i;
    }
  }

  /** Sends what changed. */
  upload(webgl: WebGLRenderer): void {
    this.table.upload(webgl);
  }

  /** Bytes sent by the last `upload`. */
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

  private classify(lights: readonly Light[], view: Matrix4): void {
    this.directionals.length = this.unboundeds.length = this.masked.length = 0;
    this.kept = 0;
    this.spheres = this.cones = this.others = 0;
    this.ambientSum.clear();
    this.total = lights.length;
    this.visible = 0;
    if (this.bounds.length < lights.length * 4) {
      this.bounds = new Float64Array(lights.length * 8);
      this.axes = new Float64Array(lights.length * 8);
      this.plain = new Float64Array(lights.length * 8);
    }
    for (const light of lights) {
      if (!this.finite.check(light)) continue;
      const l = light as PointLight & SpotLight & DirectionalLight & { isPointLight?: boolean };
      if (l.isPointLight || l.isSpotLight) {
        if (isBlackLight(light)) continue;
        const range = lightRange(l);
        if (range <= 0) {
          this.unboundeds.push(light);
          if (this.mayBeMasked(light)) this.masked.push(light);
        } else this.findBounded(light, view);
      } else if (l.isDirectionalLight) {
        if (isBlackLight(light)) continue;
        this.directionals.push(l);
        if (this.mayBeMasked(light)) this.masked.push(light);
      } else {
        this.visible++;
        if ('isHemisphereLight' in light) this.ambientSum.addHemisphere(light as HemisphereLight, view);
        else this.ambientSum.addAmbient(light);
      }
    }
  }

  /** Keeps a light with a range unless the frustum says that it reaches nothing that is seen. */
  private findBounded(light: Light, view: Matrix4): void {
    const range = lightRange(light as PointLight);
    const v = view.elements;
    const m = light.matrixWorld.elements;
    const wx = m[12];
    const wy = m[13];
    const wz = m[14];
    const x = v[0] * wx + v[4] * wy + v[8] * wz + v[12];
    const y = v[1] * wx + v[5] * wy + v[9] * wz + v[13];
    const z = v[2] * wx + v[6] * wy + v[10] * wz + v[14];
    if (sphereOutsidePlanes(planes, x, y, z, range)) return;
    const { bounds, axes, plain } = this;
    const at = this.kept * 4;
    const spot = light as SpotLight;
    const isMasked = this.mayBeMasked(light);
    const isPlain = spot.isSpotLight !== true && light.userData.farol === undefined && !isMasked;
    if (isPlain) {
      const { color, intensity } = light;
      plain[at] = color.r * intensity;
      plain[at + 1] = color.g * intensity;
      plain[at + 2] = color.b * intensity;
    }
    plain[at + 3] = isPlain ? (light as PointLight).decay : -1;
    bounds[at] = x;
    bounds[at + 1] = y;
    bounds[at + 2] = z;
    bounds[at + 3] = range;
    if (spot.isSpotLight === true && spot.angle < WIDEST_CONE) {
      lightAxis(spot, view, axis);
      coneBoundingSphere(x, y, z, -axis.x, -axis.y, -axis.z, range, spot.angle, coneSphere);
      if (sphereOutsidePlanes(planes, coneSphere[0], coneSphere[1], coneSphere[2], coneSphere[3])) return;
      axes[at] = axis.x;
      axes[at + 1] = axis.y;
      axes[at + 2] = axis.z;
      axes[at + 3] = Math.cos(spot.angle);
      this.cones++;
    } else {
      axes[at] = axes[at + 1] = 0;
      axes[at + 2] = 1;
      axes[at + 3] = -1;
      this.spheres++;
    }
    if (!isPlain) this.others++;
    if (isMasked) this.masked.push(light);
    this.boundeds[this.kept++] = light;
    this.coverage += this.coverageOf(-z, range);
  }

  /** Keeps an order, but plain point lights come first, and the others from a new quad of 128 on. */
  private plainFirst(count: number, order: Uint32Array): Uint32Array {
    const { plain } = this;
    let plains = 0;
    for (let i = 0; i < count; i++) if (plain[i * 4 + 3] >= 0) plains++;
    this.plainQuads = Math.ceil(plains / 128);
    this.bounded = plains === count ? count : this.plainQuads * 128 + count - plains;
    const ranks = this.volumes.length < this.bounded ? new Uint32Array(this.bounded * 2) : this.volumes;
    ranks.fill(NO_LIGHT, plains, this.bounded);
    let a = 0;
    let b = this.plainQuads * 128;
    for (let k = 0; k < count; k++) {
      const i = order[k];
      if (plain[i * 4 + 3] >= 0) ranks[a++] = i;
      else ranks[b++] = i;
    }
    return ranks;
  }

  /** Share of the picture that a sphere covers, roughly, 0 to 1. */
  private coverageOf(depth: number, radius: number): number {
    const p = this.projection;
    const scale = p[11] === 0 ? radius : radius / Math.max(depth, radius);
    return Math.min(1, (Math.PI / 4) * scale * scale * Math.abs(p[0] * p[5]));
  }

  private mayBeMasked(light: Light): boolean {
    return (light.castShadow && this.shadows) || cookieOf(light) !== null || this.layers?.separates(light) === true;
  }

  /** Writes the k-th light with a range. */
  private writeBounded(record: number, k: number, view: Matrix4): void {
    const { bounds } = this;
    const i = this.rank[k];
    if (i === NO_LIGHT) {
      // lights nothing, for loops that know no lists
      this.table.set4(record * FLOATS_PER_RECORD, 0, 0, 0, 1);
      this.table.set4(record * FLOATS_PER_RECORD + 4, 0, 0, 0, 2);
      return;
    }
    const at = i * 4;
    const { plain, table } = this;
    if (plain[at + 3] >= 0) {
      const to = record * FLOATS_PER_RECORD;
      table.set4(to, bounds[at], bounds[at + 1], bounds[at + 2], bounds[at + 3]);
      table.set4(to + 4, plain[at], plain[at + 1], plain[at + 2], plain[at + 3]);
      return;
    }
    this.records.writeLocal(record, this.boundeds[i], bounds[at], bounds[at + 1], bounds[at + 2], view);
  }
}
