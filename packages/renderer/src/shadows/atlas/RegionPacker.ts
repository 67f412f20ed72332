import type { Region } from './AtlasPlacement';

/**
 * Packs rectangles into a square and frees them again: guillotine cuts, best fit by the shorter side left over, and
 * free rectangles joined where two share a whole side.
 * @see Jylänki 2010, A Thousand Ways to Pack the Bin
 */
export class RegionPacker {
  private free: Region[] = [];

  /** @param size - side of the square (texels) */
  constructor(public size: number) {
    this.clear(size);
  }

  /** Frees all rectangles and sets the side (texels). */
  clear(size: number): void {
    this.size = size;
    this.free = [{ x: 0, y: 0, width: size, height: size }];
  }

  /** Finds and takes a free rectangle of a size (texels); null when there is none. */
  place(width: number, height: number): Region | null {
    let best = -1;
    let least = Infinity;
    for (let i = 0; i < this.free.length; i++) {
      const f = this.free[i];
      if (f.width < width || f.height < height) continue;
      const left = Math.min(f.width - width, f.height - height);
      if (left < least) {
        least = left;
        best = i;
      }
    }
    if (best < 0) return null;
    const { x, y, width: w, height: h } = this.free[best];
    this.free[best] = this.free[this.free.length - 1];
    this.free.pop();
    // cut so that the larger of the two remaining rectangles stays whole
    const right = w - width;
    const above = h - height;
    const tall = right > above;
    this.add(x + width, y, right, tall ? h : height);
    this.add(x, y + height, tall ? width : w, above);
    return { x, y, width, height };
  }

  /** Frees a rectangle. */
  release(region: Region): void {
    let { x, y, width, height } = region;
    for (let i = 0; i < this.free.length;) {
      const f = this.free[i];
      const beside = f.y === y && f.height === height && (f.x + f.width === x || x + width === f.x);
      const over = f.x === x && f.width === width && (f.y + f.height === y || y + height === f.y);
      if (!beside && !over) {
        i++;
        continue;
      }
      if (beside) width += f.width;
      else height += f.height;
      x = Math.min(x, f.x);
      y = Math.min(y, f.y);
      this.free[i] = this.free[this.free.length - 1];
      this.free.pop();
      i = 0;
    }
    this.add(x, y, width, height);
  }

  private add(x: number, y: number, width: number, height: number): void {
    if (width > 0 && height > 0) this.free.push({ x, y, width, height });
  }
}
