/** Maximum number of receiver boxes remembered from a frame. */
const MOST = 48;

/**
 * Indices of the boxes that widened the visible parts of a light's map in the last frame. The next frame tries them first, so
 * that other boxes rarely widen. An index that now belongs to another box only costs time.
 */
export class Widest {
  readonly list = new Int32Array(MOST);
  count = 0;
  private readonly found = new Int32Array(MOST);
  private readonly kept = new Int32Array(MOST);
  private foundCount = 0;
  private keptCount = 0;

  /** Keeps a receiver's box in the list for the next frame, since it has widened the visible parts of a map again. */
  keep(box: number): void {
    this.kept[this.keptCount++] = box;
  }

  /** Notes that a box that is not in the list has widened the visible parts of a map. */
  find(box: number): void {
    this.found[this.foundCount++ % MOST] = box;
  }

  /** Makes the list of boxes that the next frame tries first. */
  end(): void {
    const { list, found, kept } = this;
    let count = 0;
    // the last box that widened the parts is the one farthest out
    while (count < Math.min(MOST, this.foundCount)) list[count++] = found[(this.foundCount - count) % MOST];
    for (let i = 0; i < this.keptCount && count < MOST; i++) list[count++] = kept[i];
    this.count = count;
    this.foundCount = this.keptCount = 0;
  }
}
