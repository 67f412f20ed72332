import { NO_LIGHT } from './lightRecord';
import type { GridFrame } from './GridFrame';
import { type GridLights, MARGIN, SHAPE, TILES } from './GridLights';

/** Number of lights, and of 32-bit words of a tile's mask, in one page of masks. */
const PAGE_LIGHTS = 128;
const PAGE_WORDS = 4;
/** Mean number of lights in a tile from which on only the ends of a page's spans are written, then filled by `spread`. */
const TOGGLE_FROM = 6;

/**
 * Bits of the lights that touch each tile. Four words (128 lights) of all tiles make a page: word `w` of tile `(x, y)` is
 * `masks[((w >> 2) * tilesY * tilesX + y * tilesX + x) * 4 + (w & 3)]`, so that a page's row of tiles is a row of RGBA32UI
 * texels, and consecutive lights write to nearby memory.
 * @see Drobot 2017, Improved Culling for Tiled and Clustered Rendering in Call of Duty: Infinite Warfare
 */
export class TileMasks {
  /** Number of 32-bit words of a tile, a multiple of 4. */
  words = 0;
  masks = new Uint32Array(0);

  /** @param order - index of the light of each of `count` ranks; NO_LIGHT for ranks without a light */
  fill(lights: GridLights, order: Uint32Array, count: number, frame: GridFrame): void {
    const pages = Math.ceil(count / PAGE_LIGHTS);
    const pageSize = frame.tilesX * frame.tilesY * PAGE_WORDS;
    this.words = pages * PAGE_WORDS;
    if (this.masks.length < pages * pageSize) this.masks = new Uint32Array(Math.ceil(pages * pageSize * 1.25));
    else this.masks.fill(0, 0, pages * pageSize);
    for (let page = 0; page < pages; page++) {
      this.fillPage(lights, order, page, Math.min(count, (page + 1) * PAGE_LIGHTS), frame);
    }
  }

  private fillPage(lights: GridLights, order: Uint32Array, page: number, end: number, frame: GridFrame): void {
    const { tiles } = lights;
    const first = page * PAGE_LIGHTS;
    let area = 0;
    for (let rank = first; rank < end; rank++) {
      if (order[rank] === NO_LIGHT) continue;
      const t = order[rank] * TILES;
      area += (tiles[t + 1] - tiles[t] + 1) * (tiles[t + 3] - tiles[t + 2] + 1);
    }
    const pageSize = frame.tilesX * frame.tilesY * PAGE_WORDS;
    const base = page * pageSize;
    const toggle = area > TOGGLE_FROM * frame.tilesX * frame.tilesY;
    for (let rank = first; rank < end; rank++) {
      const light = order[rank];
      if (light === NO_LIGHT) continue;
      const word = base + ((rank >> 5) & 3);
      const t = light * TILES;
      if (tiles[t + 1] - tiles[t] > 1 && tiles[t + 3] - tiles[t + 2] > 1)
        this.markOutline(lights, light, word, 1 << (rank & 31), toggle, frame);
      else this.markRectangle(tiles, t, word, 1 << (rank & 31), toggle, frame.tilesX);
    }
    if (toggle) this.spread(base, pageSize, frame.tilesX * PAGE_WORDS);
  }

  /** Marks, row by row, the columns that the outline of a sphere spans. */
  private markOutline(
    lights: GridLights,
    light: number,
    word: number,
    bit: number,
    toggle: boolean,
    frame: GridFrame,
  ): void {
    const { shapes, tiles } = lights;
    const { scaleX, scaleY, offsetX, offsetY, tilesX } = frame;
    const { masks } = this;
    const at = light * SHAPE;
    const t = light * TILES;
    const left = tiles[t];
    const right = tiles[t + 1];
    const bottomRow = tiles[t + 2];
    const topRow = tiles[t + 3];
    const x = shapes[at];
    const y = shapes[at + 1];
    const depth = shapes[at + 2];
    const radius = shapes[at + 3];
    const bottom = shapes[at + 6];
    const top = shapes[at + 7];

    // at slope s the outline is at the columns a + b s ± c √(d + e s + f s²); also finds the rows of its leftmost and rightmost
    // points
    let a = offsetX + x * scaleX;
    let b = 0;
    let c = scaleX;
    let d = radius * radius - y * y;
    let e = 2 * y;
    let f = -1;
    let leftRow = Math.floor(y * scaleY + offsetY);
    let rightRow = leftRow;
    let openLeft = false;
    let openRight = false;
    if (frame.perspective) {
      // a ray (t, s, 1) meets the sphere where (centre · ray)² >= k |ray|²
      const squared = x * x + depth * depth;
      const k = squared + y * y - radius * radius;
      const m = k - x * x;
      if (!(k > 0) || Math.abs(m) < 1e-9 * k) return this.markRectangle(tiles, t, word, bit, toggle, tilesX);
      // a sphere beside the eye has an outline that is open to that side
      openLeft = m < 0 && x < 0;
      openRight = m < 0 && x > 0;
      const scale = scaleX / m;
      a = offsetX + x * depth * scale;
      b = x * y * scale;
      c = Math.sqrt(k) * Math.abs(scale);
      d = depth * depth - m;
      e = 2 * y * depth;
      f = y * y - m;
      // depths at which the tangents from the camera touch the sphere
      const tangent = Math.sqrt(Math.max(0, squared - radius * radius));
      const low = (depth * tangent + x * radius) * tangent;
      const high = (depth * tangent - x * radius) * tangent;
      leftRow = low > 0 ? Math.floor(((y * squared) / low) * scaleY + offsetY) : -1;
      rightRow = high > 0 ? Math.floor(((y * squared) / high) * scaleY + offsetY) : -1;
    }
    const step = 1 / scaleY;
    let s = (bottomRow - offsetY) * step;
    if (s < bottom) s = bottom;
    let inside = d + s * (e + s * f);
    let half = inside > 0 ? c * Math.sqrt(inside) : 0;
    let low = a + b * s + (openRight ? half : -half);
    let high = a + b * s + (openLeft ? -half : half);
    for (let row = bottomRow; row <= topRow; row++) {
      s = (row + 1 - offsetY) * step;
      if (s > top) s = top;
      inside = d + s * (e + s * f);
      half = inside > 0 ? c * Math.sqrt(inside) : 0;
      const low1 = a + b * s + (openRight ? half : -half);
      const high1 = a + b * s + (openLeft ? -half : half);
      let from = left;
      let to = right;
      if (row !== leftRow && !openLeft) {
        const least = (low < low1 ? low : low1) - MARGIN;
        if (least > from) from = least < tilesX ? least | 0 : tilesX;
      }
      if (row !== rightRow && !openRight) {
        const greatest = (high > high1 ? high : high1) + MARGIN;
        if (greatest < to) to = greatest < 0 ? -1 : greatest | 0;
      }
      low = low1;
      high = high1;
      if (from > to) continue;
      let start = word + (row * tilesX + from) * PAGE_WORDS;
      const end = start + (to - from) * PAGE_WORDS;
      if (toggle) {
        masks[start] ^= bit;
        if (to + 1 < tilesX) masks[end + PAGE_WORDS] ^= bit;
      } else for (; start <= end; start += PAGE_WORDS) masks[start] |= bit;
    }
  }

  private markRectangle(
    tiles: Uint16Array,
    t: number,
    word: number,
    bit: number,
    toggle: boolean,
    tilesX: number,
  ): void {
    const { masks } = this;
    const from = tiles[t];
    const to = tiles[t + 1];
    for (let row = tiles[t + 2]; row <= tiles[t + 3]; row++) {
      let start = word + (row * tilesX + from) * PAGE_WORDS;
      const end = start + (to - from) * PAGE_WORDS;
      if (toggle) {
        masks[start] ^= bit;
        if (to + 1 < tilesX) masks[end + PAGE_WORDS] ^= bit;
      } else for (; start <= end; start += PAGE_WORDS) masks[start] |= bit;
    }
  }

  /** Fills the bits between the two marked ends of each span of tiles. */
  private spread(base: number, size: number, rowSize: number): void {
    const { masks } = this;
    for (let row = base; row < base + size; row += rowSize) {
      let a = 0;
      let b = 0;
      let c = 0;
      let d = 0;
      for (let at = row; at < row + rowSize; at += PAGE_WORDS) {
        masks[at] = a ^= masks[at];
        masks[at + 1] = b ^= masks[at + 1];
        masks[at + 2] = c ^= masks[at + 2];
        masks[at + 3] = d ^= masks[at + 3];
      }
    }
  }
}
