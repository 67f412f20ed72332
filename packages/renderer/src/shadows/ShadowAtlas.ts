import {
  DepthTexture,
  GreaterEqualCompare,
  LessEqualCompare,
  LinearFilter,
  NearestFilter,
  RedFormat,
  UnsignedIntType,
  WebGLRenderTarget,
} from 'three';
import { CUBE_BORDER, type ShadowSlot } from './ShadowSlot';
import { TilePacker } from './TilePacker';

/** Texels a side of the smallest atlas. */
const SMALLEST = 512;
/** Texels a side below which a map is not halved. */
const SMALLEST_MAP = 32;
/** Part of the atlas that tiles of mixed sizes are counted on to fill. */
const FILLED = 0.9;

/**
 * One depth texture in which every shadow map has a tile, of the size that the light asks for. It grows with what is asked
 * of it, up to a limit; then the maps of lights that cover least of the picture for their size are halved.
 */
export class ShadowAtlas {
  /** Depth of all maps, to be compared by the sampler; null before the first light. */
  target: WebGLRenderTarget | null = null;
  private readonly packer = new TilePacker(SMALLEST);
  private readonly order: ShadowSlot[] = [];
  private reduced = false;
  /** Part of the largest atlas that maps are reduced to: less after they did not fit. */
  private filled = FILLED;

  /** @param limit texels a side at most */
  constructor(public limit: number) {}

  get texture(): DepthTexture | null {
    return this.target?.depthTexture ?? null;
  }

  get bytes(): number {
    return this.target === null ? 0 : this.target.width * this.target.height * 5;
  }

  /**
   * Gives every slot a tile of the size that it asks for, or a half, a quarter… of it where there is no room.
   * @param slots those of lit lights
   * @param kept tiles of lights that are not lit now; they are taken when room is needed
   * @param rebalance looks again at who has been reduced
   */
  arrange(slots: readonly ShadowSlot[], kept: readonly ShadowSlot[], rebalance: boolean): void {
    if (slots.length === 0) return;
    if (this.target === null) this.resize(SMALLEST);
    if (rebalance && this.reduced && this.reduce(slots)) {
      this.repack(slots, kept);
      return;
    }
    for (const slot of slots) {
      const width = mapWidth(slot, this.limit);
      const height = mapHeight(slot, this.limit);
      if (slot.tile !== null && slot.faceWidth === width && slot.faceHeight === height) continue;
      this.release(slot);
      if (this.tryPlace(slot, width, height)) continue;
      this.repack(slots, kept);
      return;
    }
  }

  /** Gives a slot's tile back. */
  release(slot: ShadowSlot): void {
    if (slot.tile === null) return;
    this.packer.release(slot.tile);
    slot.tile = null;
    slot.drawn = false;
  }

  /** The depths that pass the sampler's comparison. */
  setReversed(reversedDepth: boolean): void {
    const { texture } = this;
    const wanted = reversedDepth ? GreaterEqualCompare : LessEqualCompare;
    if (texture !== null && texture.compareFunction !== wanted) texture.compareFunction = wanted;
  }

  dispose(): void {
    this.target?.depthTexture?.dispose();
    this.target?.dispose();
    this.target = null;
  }

  private tryPlace(slot: ShadowSlot, width: number, height: number): boolean {
    const tile = this.packer.place(blockWidth(slot, width), blockHeight(slot, height));
    if (tile !== null) slot.place(tile, width, height);
    return tile !== null;
  }

  /** Places all anew, the largest first, in the smallest atlas that has room, with maps halved where the largest has none. */
  private repack(slots: readonly ShadowSlot[], kept: readonly ShadowSlot[]): void {
    const { limit, order } = this;
    for (const slot of kept) {
      slot.tile = null;
      slot.drawn = false;
    }
    order.length = 0;
    for (const slot of slots) order.push(slot);
    this.filled = FILLED;
    for (;;) {
      this.reduce(slots);
      let area = 0;
      for (const slot of slots) area += areaOf(slot, limit);
      order.sort((a, b) => blockHeight(b, mapHeight(b, limit)) - blockHeight(a, mapHeight(a, limit)));
      let size = this.target!.width;
      while (size < limit && size * size * FILLED < area) size *= 2;
      while (!this.placeAll(Math.min(size, limit)) && size < limit) size *= 2;
      size = Math.min(size, limit);
      if (size !== this.target!.width) this.resize(size);
      if (order.every((slot) => slot.tile !== null) || this.filled < 0.2) return;
      this.filled *= 0.9;
    }
  }

  /**
   * Halves the maps that have most texels for what their lights cover of the picture, until all may fit.
   * @returns whether any map's size changed by that
   */
  private reduce(slots: readonly ShadowSlot[]): boolean {
    const { limit } = this;
    let area = 0;
    for (const slot of slots) {
      slot.halved = slot.halvings;
      slot.halvings = 0;
      area += areaOf(slot, limit);
    }
    this.reduced = false;
    while (area > limit * limit * this.filled) {
      const freed = this.halve(slots);
      if (freed === 0) break;
      area -= freed;
    }
    return slots.some((slot) => slot.halved !== slot.halvings);
  }

  private placeAll(size: number): boolean {
    const { limit, packer, order } = this;
    packer.clear(size);
    for (const slot of order) slot.tile = null;
    for (const slot of order) {
      slot.drawn = false;
      if (!this.tryPlace(slot, mapWidth(slot, limit), mapHeight(slot, limit))) return false;
    }
    return true;
  }

  /** Halves the map that has most texels for what its light covers of the picture. @returns the texels freed */
  private halve(slots: readonly ShadowSlot[]): number {
    let worst: ShadowSlot | null = null;
    let most = 0;
    for (const slot of slots) {
      if (Math.min(mapWidth(slot, this.limit), mapHeight(slot, this.limit)) <= SMALLEST_MAP) continue;
      const waste = areaOf(slot, this.limit) / Math.max(slot.coverage, 1e-4);
      if (waste <= most) continue;
      most = waste;
      worst = slot;
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
    const depthTexture = new DepthTexture(size, size, UnsignedIntType);
    depthTexture.name = 'Farol shadow maps';
    depthTexture.compareFunction = LessEqualCompare;
    depthTexture.minFilter = depthTexture.magFilter = LinearFilter;
    this.target = new WebGLRenderTarget(size, size, {
      format: RedFormat,
      minFilter: NearestFilter,
      magFilter: NearestFilter,
      depthTexture,
    });
  }
}

function mapWidth(slot: ShadowSlot, limit: number): number {
  return sideOf(slot.wantedWidth, slot, limit);
}

function mapHeight(slot: ShadowSlot, limit: number): number {
  return sideOf(slot.wantedHeight, slot, limit);
}

/** Texels a side of a face: as the light asks, but no more than fit alone, halved as there is need. */
function sideOf(wanted: number, slot: ShadowSlot, limit: number): number {
  const most = slot.isPoint ? Math.floor(limit / 3) - 2 * CUBE_BORDER : limit;
  return Math.max(1, Math.min(wanted, most) >> slot.halvings);
}

function blockWidth(slot: ShadowSlot, face: number): number {
  return slot.isPoint ? 3 * (face + 2 * CUBE_BORDER) : face;
}

function blockHeight(slot: ShadowSlot, face: number): number {
  return slot.isPoint ? 2 * (face + 2 * CUBE_BORDER) : face;
}

function areaOf(slot: ShadowSlot, limit: number): number {
  return blockWidth(slot, mapWidth(slot, limit)) * blockHeight(slot, mapHeight(slot, limit));
}
