import type { Texture, WebGLRenderTarget } from 'three';
import type { AtlasMap } from './AtlasMap';
import type { AtlasPlacement } from './AtlasPlacement';
import type { MapDetail } from './MapDetail';
import { mipmapBlockHeight, mipmapBlockWidth } from './mipmapBlock';
import { RegionPacker } from './RegionPacker';

/** Owner of an atlas region: a map, or the six faces of a cube, three by two, with borders. */
export interface AtlasTenant {
  readonly isCube: boolean;
  /** Number of maps along a side, for a tenant that is a square of several shadow maps; 1 when absent. */
  readonly side?: number;
  /** Side set by the light (texels). */
  readonly wantedWidth: number;
  readonly wantedHeight: number;
  /** Share of the picture that the light covers, 0 to 1. */
  readonly coverage: number;
  /** Rectangle of the map in the atlas; written by the atlas. */
  readonly placement: AtlasPlacement;
  /** State of the content of the map's region. */
  readonly map: AtlasMap;
  /** Number of times that the map is halved because pictures would not show its full size; never when undefined. */
  readonly detail?: MapDetail;
  /** Number of mipmap levels of an image, laid out by mipmapBlock.ts; when undefined, one level, bordered only for cubes. */
  readonly levels?: number;
  /**
   * Width of the border round each face of a cube with sides of `faceWidth` texels: it repeats the neighbouring faces,
   * so that filters cross edges.
   */
  borderOf(faceWidth: number): number;
  /** Called when the map has moved to another region. */
  placed?(): void;
}

/** Side of the smallest atlas (texels). */
const SMALLEST = 512;
/** Side of an atlas (texels) beyond which it no longer doubles, but grows in smaller steps. */
const FINE_STEPS = 4096;
/** Side of a shadow map (texels) at and below which it is not halved. */
const SMALLEST_MAP = 16;
/** Minimum number of rebalancings of a full atlas between two times that all maps are placed anew. */
const REBALANCINGS = 10;
/** Share of the atlas that regions of mixed sizes are expected to fill. */
const FILLED = 0.9;

/**
 * One texture in which every shadow map (or image) has a region of its wanted size. The texture grows as needed, up to a limit;
 * then maps are halved whose lights cover least of the picture for their size.
 */
export class TextureAtlas {
  target: WebGLRenderTarget | null = null;
  private readonly packer = new RegionPacker(SMALLEST);
  private readonly order: AtlasTenant[] = [];
  /** Whether some maps are halved because the atlas is full. */
  reduced = false;
  /** Number of rebalancings so far. */
  private rebalancings = 0;
  /** Share of the largest atlas that maps may fill after `reduce`, 0 to 1: lowered when they did not fit. */
  private filled = 1;

  /** @param limit - largest side (texels) @param make - makes a target with a given side (texels) */
  constructor(
    private limit: number,
    /** Bytes of a texel of the target. */
    readonly bytesPerTexel: () => number,
    private readonly make: (size: number) => WebGLRenderTarget,
  ) {}

  /**
   * Texture that shaders read: the target's depths if it has a texture of them, else its colours; null while there is
   * no target.
   */
  get texture(): Texture | null {
    return this.target?.depthTexture ?? this.target?.texture ?? null;
  }

  /** Side of the atlas (texels). */
  get size(): number {
    return this.target?.width ?? 1;
  }

  get bytes(): number {
    return this.target === null ? 0 : this.target.width * this.target.height * this.bytesPerTexel();
  }

  /**
   * Gives every tenant a region of its wanted size, or, when there is no room, of a half, a quarter… of it.
   * @param tenants - maps of the frame's lights
   * @param kept - maps of lights outside of this frame; their regions are freed when room is needed
   * @param rebalances - whether a full atlas chooses anew which maps are halved
   */
  arrange(tenants: readonly AtlasTenant[], kept: readonly AtlasTenant[], rebalances: boolean): void {
    if (tenants.length === 0) return;
    if (this.target === null) this.resize(SMALLEST);
    const { limit, order } = this;
    const rebalancing = rebalances && this.reduced;
    if (rebalancing) this.reduce(tenants);
    order.length = 0;
    for (const tenant of tenants) {
      if (isPlaced(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) continue;
      this.release(tenant);
      order.push(tenant);
    }
    if (order.length > 1) this.sort();
    // free room may be in pieces: some maps are then halved, and all are placed anew only in every tenth rebalancing
    const squeezes = rebalancing && kept.length === 0 && ++this.rebalancings % REBALANCINGS !== 0;
    for (const tenant of order) {
      if (this.tryPlace(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) continue;
      if (squeezes && this.squeeze(tenant)) continue;
      this.repack(tenants, kept);
      return;
    }
  }

  /**
   * Raises the greatest side of the atlas.
   * @param limit - side (texels); a smaller limit than before changes nothing
   */
  raiseLimit(limit: number): void {
    this.limit = Math.max(this.limit, limit);
  }

  /** Resets the atlas: no render target and no limit. All regions must have been released. */
  clear(): void {
    this.dispose();
    this.limit = 0;
    this.reduced = false;
  }

  /** Frees the region of a shadow map or cookie. */
  release(tenant: AtlasTenant): void {
    const { region } = tenant.placement;
    if (region === null) return;
    this.packer.release(region);
    drop(tenant);
  }

  /** Makes a new target by `make`; the contents of regions are lost. */
  remake(): void {
    if (this.target !== null) this.resize(this.target.width);
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = null;
  }

  private tryPlace(tenant: AtlasTenant, width: number, height: number): boolean {
    const region = this.packer.place(blockWidth(tenant, width), blockHeight(tenant, height));
    if (region === null) return false;
    tenant.placement.place(region, width, height, tenant.isCube ? tenant.borderOf(width) : 0);
    tenant.map.place();
    tenant.placed?.();
    return true;
  }

  /** Places a map with a half, a quarter… of its texels, if there is room. @returns whether there was */
  private squeeze(tenant: AtlasTenant): boolean {
    const { limit } = this;
    while (Math.min(mapWidth(tenant, limit), mapHeight(tenant, limit)) > SMALLEST_MAP) {
      tenant.placement.halve();
      this.reduced = true;
      if (this.tryPlace(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) return true;
    }
    return false;
  }

  private sort(): void {
    const { limit } = this;
    this.order.sort((a, b) => blockHeight(b, mapHeight(b, limit)) - blockHeight(a, mapHeight(a, limit)));
  }

  /**
   * Places all maps anew, the largest first, in the smallest atlas that has room; halves maps if even the largest has
   * none.
   */
  private repack(tenants: readonly AtlasTenant[], kept: readonly AtlasTenant[]): void {
    const { limit, order } = this;
    for (const tenant of kept) drop(tenant);
    order.length = 0;
    for (const tenant of tenants) order.push(tenant);
    this.filled = 1;
    for (;;) {
      this.reduce(tenants);
      let area = 0;
      for (const tenant of tenants) area += areaOf(tenant, limit);
      this.sort();
      let size = this.target!.width;
      while (size < limit && size * size * FILLED < area) size = larger(size);
      while (!this.placeAll(Math.min(size, limit)) && size < limit) size = larger(size);
      size = Math.min(size, limit);
      if (size !== this.target!.width) this.resize(size);
      if (order.every(({ placement }) => placement.region !== null) || this.filled < 0.2) return;
      this.filled *= 0.9;
    }
  }

  /** Halves the maps with most texels for the share of the picture that their lights cover, until all may fit. */
  private reduce(tenants: readonly AtlasTenant[]): void {
    const { limit } = this;
    let area = 0;
    for (const tenant of tenants) {
      tenant.placement.restore();
      tenant.detail?.settle();
      area += areaOf(tenant, limit);
    }
    this.reduced = false;
    while (area > limit * limit * this.filled) {
      const freed = this.halve(tenants);
      if (freed === 0) break;
      area -= freed;
    }
  }

  private placeAll(size: number): boolean {
    const { limit, packer, order } = this;
    packer.clear(size);
    for (const tenant of order) drop(tenant);
    for (const tenant of order) {
      if (!this.tryPlace(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) return false;
    }
    return true;
  }

  /** Halves the map with most texels for the share of the picture that its light covers. @returns number of texels freed */
  private halve(tenants: readonly AtlasTenant[]): number {
    let worst: AtlasTenant | null = null;
    let most = 0;
    for (const tenant of tenants) {
      if (Math.min(mapWidth(tenant, this.limit), mapHeight(tenant, this.limit)) <= SMALLEST_MAP) continue;
      const waste = areaOf(tenant, this.limit) / Math.max(tenant.coverage, 1e-4);
      if (waste <= most) continue;
      most = waste;
      worst = tenant;
    }
    if (worst === null) return 0;
    const before = areaOf(worst, this.limit);
    worst.placement.halve();
    this.reduced = true;
    return before - areaOf(worst, this.limit);
  }

  private resize(size: number): void {
    this.dispose();
    if (this.packer.size !== size) this.packer.clear(size);
    this.target = this.make(size);
  }
}

/** Next size of an atlas: twice as wide, or, beyond FINE_STEPS, a quarter of a power of two more. */
function larger(size: number): number {
  return size < FINE_STEPS ? 2 * size : size + (1 << (29 - Math.clz32(size)));
}

function drop({ placement, map }: AtlasTenant): void {
  placement.drop();
  map.release();
}

/**
 * True when a tenant's region fits faces of this size (texels), with the borders and mipmap levels that the tenant
 * needs now.
 */
function isPlaced(tenant: AtlasTenant, width: number, height: number): boolean {
  const { region, faceWidth, faceHeight } = tenant.placement;
  if (region === null || faceWidth !== width || faceHeight !== height) return false;
  return region.width === blockWidth(tenant, width) && region.height === blockHeight(tenant, height);
}

function mapWidth(tenant: AtlasTenant, limit: number): number {
  return sideOf(tenant.wantedWidth, tenant, limit);
}

function mapHeight(tenant: AtlasTenant, limit: number): number {
  return sideOf(tenant.wantedHeight, tenant, limit);
}

/**
 * Side of a face of a shadow map (texels): the lesser of the light's and the pictures' need, limited to the atlas,
 * halved while the atlas is full.
 */
function sideOf(asked: number, tenant: AtlasTenant, limit: number): number {
  const wanted = asked >> (tenant.detail?.level ?? 0);
  // mipmaps of a cube are as high as three faces plus the borders of all levels
  const third = Math.floor((limit - 4 * (tenant.levels ?? 0)) / 3);
  const most = tenant.isCube
    ? third - 2 * tenant.borderOf(Math.min(wanted, third))
    : Math.floor(limit / (tenant.side ?? 1));
  return Math.max(1, Math.min(wanted, most) >> tenant.placement.halvings);
}

function blockWidth(tenant: AtlasTenant, face: number): number {
  if (tenant.levels !== undefined) return mipmapBlockWidth(face, tenant.levels, tenant.isCube ? 3 : 1);
  return tenant.isCube ? 3 * (face + 2 * tenant.borderOf(face)) : face * (tenant.side ?? 1);
}

function blockHeight(tenant: AtlasTenant, face: number): number {
  if (tenant.levels !== undefined) return mipmapBlockHeight(face, tenant.levels, tenant.isCube ? 2 : 1);
  return tenant.isCube ? 2 * (face + 2 * tenant.borderOf(face)) : face * (tenant.side ?? 1);
}

function areaOf(tenant: AtlasTenant, limit: number): number {
  return blockWidth(tenant, mapWidth(tenant, limit)) * blockHeight(tenant, mapHeight(tenant, limit));
}
