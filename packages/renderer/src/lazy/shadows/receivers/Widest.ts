/** Boxes remembered at most. */
const MOST = 48;

/**
 * The boxes that widened the parts of a light's maps in the last frame, by index: where they come first, few others widen
 * them more. Those that still did then come first of all in the next frame, so that it is few that are remembered. Where an
 * index has come to mean another box, no more is lost than time.
 */
export class Widest {
  readonly list = new Int32Array(MOST);
  count = 0;
  private readonly found = new Int32Array(MOST);
  private readonly kept = new Int32Array(MOST);
  private foundCount = 0;
  private keptCount = 0;

  /** One of the list has widened them again. */
  keep(box: number): void {
    this.kept[this.keptCount++] = box;
  }

  /** One of the others has. */
  find(box: number): void {
    this.found[this.foundCount++ % MOST] = box;
  }

  /** Makes the list of the next frame. */
  end(): void {
    const { list, found, kept } = this;
    let count = 0;
    // the last to widen them is the widest
    while (count < Math.min(MOST, this.foundCount)) list[count++] = found[(this.foundCount - count) % MOST];
    for (let i = 0; i < this.keptCount && count < MOST; i++) list[count++] = kept[i];
    this.count = count;
    this.foundCount = this.keptCount = 0;
  }
}
