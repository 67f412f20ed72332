import type { Texture, WebGLRenderTarget } from 'three';
import { TilePacker, type Tile } from './TilePacker';

/** What has a tile in an atlas: a map, or the six faces of a cube, three by two, with borders. */
export interface AtlasTenant {
  readonly isCube: boolean;
  /** Texels round each face of a cube of this size, from what lies beside it, so that filters cross its edges. */
  borderOf(faceWidth: number): number;
  /** Maps a side of a square of several; 1 when absent. */
  readonly side?: number;
  /** Texels a side that are asked for. */
  readonly wantedWidth: number;
  readonly wantedHeight: number;
  /** Share of the picture that it matters for, 0 to 1. */
  readonly coverage: number;
  /** The place of all faces together. */
  tile: Tile | null;
  /** Texels a side of a face that the tile was made for. */
  faceWidth: number;
  faceHeight: number;
  /** How often the size asked for is halved, since no picture shows more; and how often it is to be. 0 when absent. */
  excess?: number;
  readonly spare?: number;
  /** How often that is halved again, since the atlas is full. */
  halvings: number;
  /** The tile holds what it should. */
  drawn: boolean;
  /** Takes a place; what it holds is to be drawn anew. */
  place(tile: Tile, faceWidth: number, faceHeight: number): void;
}

/** Texels a side of the smallest atlas. */
const SMALLEST = 512;
/** Texels a side of an atlas from which on it grows by less than its size. */
const FINE_STEPS = 4096;
/** Texels a side below which a map is not halved. */
const SMALLEST_MAP = 16;
/** Looks at who has been reduced, of which one may place all anew. */
const LOOKS = 10;
/** Part of the atlas that tiles of mixed sizes are counted on to fill. */
const FILLED = 0.9;

/**
 * One texture in which every shadow map (or image) has a tile, of the size that is asked for. It grows with what is asked
 * of it, up to a limit; then the tiles of lights that cover least of the picture for their size are halved.
 */
export class TileAtlas {
  target: WebGLRenderTarget | null = null;
  private readonly packer = new TilePacker(SMALLEST);
  private readonly order: AtlasTenant[] = [];
  /** Maps are halved since it is full. */
  reduced = false;
  /** Counts the looks at who has been reduced. */
  private looks = 0;
  /** Part of the largest atlas that maps are reduced to: less after they did not fit. */
  private filled = 1;

  /**
   * @param limit texels a side at most
   * @param bytesPerTexel of its target
   * @param make a target of so many texels a side
   */
  constructor(
    private limit: number,
    private readonly bytesPerTexel: () => number,
    private readonly make: (size: number) => WebGLRenderTarget,
  ) {}

  /** What shaders read: depth if the target has a texture of it; null while there is no target. */
  get texture(): Texture | null {
    return this.target?.depthTexture ?? this.target?.texture ?? null;
  }

  /** Texels a side. */
  get size(): number {
    return this.target?.width ?? 1;
  }

  get bytes(): number {
    return this.target === null ? 0 : this.target.width * this.target.height * this.bytesPerTexel();
  }

  /**
   * Gives every tenant a tile of the size that it asks for, or a half, a quarter… of it where there is no room.
   * @param tenants those of lit lights
   * @param kept tiles of lights that are not lit now; they are taken when room is needed
   * @param rebalance looks again at who has been reduced
   */
  arrange(tenants: readonly AtlasTenant[], kept: readonly AtlasTenant[], rebalance: boolean): void {
    if (tenants.length === 0) return;
    if (this.target === null) this.resize(SMALLEST);
    const { limit, order } = this;
    const looks = rebalance && this.reduced;
    if (looks) this.reduce(tenants);
    order.length = 0;
    for (const tenant of tenants) {
      if (isPlaced(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) continue;
      this.release(tenant);
      order.push(tenant);
    }
    if (order.length > 1) this.sort();
    // where free places are in pieces some make do with less, and only now and then all are placed anew
    const squeezes = looks && kept.length === 0 && ++this.looks % LOOKS !== 0;
    for (const tenant of order) {
      if (this.tryPlace(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) continue;
      if (squeezes && this.squeeze(tenant)) continue;
      this.repack(tenants, kept);
      return;
    }
  }

  /** @param limit texels a side that it may have from now on; it never becomes less */
  raiseLimit(limit: number): void {
    this.limit = Math.max(this.limit, limit);
  }

  /** Gives a tenant's tile back. */
  release(tenant: AtlasTenant): void {
    if (tenant.tile === null) return;
    this.packer.release(tenant.tile);
    tenant.tile = null;
    tenant.drawn = false;
  }

  /** Makes its target anew, as `make` now does; what the tiles held is lost. */
  remake(): void {
    if (this.target !== null) this.resize(this.target.width);
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = null;
  }

  private tryPlace(tenant: AtlasTenant, width: number, height: number): boolean {
    const tile = this.packer.place(blockWidth(tenant, width), blockHeight(tenant, height));
    if (tile !== null) tenant.place(tile, width, height);
    return tile !== null;
  }

  /** Places a map where there is room for a half, a quarter… of it. */
  private squeeze(tenant: AtlasTenant): boolean {
    const { limit } = this;
    while (Math.min(mapWidth(tenant, limit), mapHeight(tenant, limit)) > SMALLEST_MAP) {
      tenant.halvings++;
      this.reduced = true;
      if (this.tryPlace(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) return true;
    }
    return false;
  }

  private sort(): void {
    const { limit } = this;
    this.order.sort((a, b) => blockHeight(b, mapHeight(b, limit)) - blockHeight(a, mapHeight(a, limit)));
  }

  /** Places all anew, the largest first, in the smallest atlas that has room, with maps halved where the largest has none. */
  private repack(tenants: readonly AtlasTenant[], kept: readonly AtlasTenant[]): void {
    const { limit, order } = this;
    for (const tenant of kept) {
      tenant.tile = null;
      tenant.drawn = false;
    }
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
      if (order.every((tenant) => tenant.tile !== null) || this.filled < 0.2) return;
      this.filled *= 0.9;
    }
  }

  /** Halves the maps that have most texels for what their lights cover of the picture, until all may fit. */
  private reduce(tenants: readonly AtlasTenant[]): void {
    const { limit } = this;
    let area = 0;
    for (const tenant of tenants) {
      tenant.halvings = 0;
      if (tenant.spare !== undefined) tenant.excess = tenant.spare;
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
    for (const tenant of order) tenant.tile = null;
    for (const tenant of order) {
      tenant.drawn = false;
      if (!this.tryPlace(tenant, mapWidth(tenant, limit), mapHeight(tenant, limit))) return false;
    }
    return true;
  }

  /** Halves the map that has most texels for what its light covers of the picture. @returns the texels freed */
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
    worst.halvings++;
    this.reduced = true;
    return before - areaOf(worst, this.limit);
  }

  private resize(size: number): void {
    this.dispose();
    if (this.packer.size !== size) this.packer.clear(size);
    this.target = this.make(size);
  }
}

/** The next size of an atlas: twice as wide, but where that is much memory a quarter of a power of two more. */
function larger(size: number): number {
  return size < FINE_STEPS ? 2 * size : size + (1 << (29 - Math.clz32(size)));
}

/** True when a tenant has a tile for faces of this size, with the border that it needs now. */
function isPlaced(tenant: AtlasTenant, width: number, height: number): boolean {
  const { tile, faceWidth, faceHeight } = tenant;
  return tile !== null && faceWidth === width && faceHeight === height && tile.width === blockWidth(tenant, width);
}

function mapWidth(tenant: AtlasTenant, limit: number): number {
  return sideOf(tenant.wantedWidth, tenant, limit);
}

function mapHeight(tenant: AtlasTenant, limit: number): number {
  return sideOf(tenant.wantedHeight, tenant, limit);
}

/** Texels a side of a face: as the light asks or pictures show, but no more than fit alone, halved as there is need. */
function sideOf(asked: number, tenant: AtlasTenant, limit: number): number {
  const wanted = asked >> (tenant.excess ?? 0);
  const third = Math.floor(limit / 3);
  const most = tenant.isCube
    ? third - 2 * tenant.borderOf(Math.min(wanted, third))
    : Math.floor(limit / (tenant.side ?? 1));
  return Math.max(1, Math.min(wanted, most) >> tenant.halvings);
}

function blockWidth(tenant: AtlasTenant, face: number): number {
  return tenant.isCube ? 3 * (face + 2 * tenant.borderOf(face)) : face * (tenant.side ?? 1);
}

function blockHeight(tenant: AtlasTenant, face: number): number {
  return tenant.isCube ? 2 * (face + 2 * tenant.borderOf(face)) : face * (tenant.side ?? 1);
}

function areaOf(tenant: AtlasTenant, limit: number): number {
  return blockWidth(tenant, mapWidth(tenant, limit)) * blockHeight(tenant, mapHeight(tenant, limit));
}
