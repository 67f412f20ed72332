/** Choices that depend on a seed alone (mulberry32 by Tommy Ettinger, public domain). */
export class Dice {
  private state: number;

  /** @param seed - whole; neighbouring seeds give unlike choices */
  constructor(seed: number) {
    this.state = Math.imul(seed + 1, 0x9e3779b1) >>> 0;
  }

  /** From 0 to below 1. */
  next(): number {
    this.state = (this.state + 0x6d2b79f5) | 0;
    let t = Math.imul(this.state ^ (this.state >>> 15), 1 | this.state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  }

  /** From `low` to below `high`, of two significant digits, which read well in a description. */
  between(low: number, high: number): number {
    return Number((low + this.next() * (high - low)).toPrecision(2));
  }

  /** A whole number from `low` to `high`. */
  whole(low: number, high: number): number {
    return low + Math.floor(this.next() * (high - low + 1));
  }

  /** True in this share of cases, 0 to 1. */
  in(share: number): boolean {
    return this.next() < share;
  }

  of<T>(list: readonly T[]): T {
    return list[Math.floor(this.next() * list.length)];
  }

  /** Runs one of these. */
  one(choices: readonly (() => void)[]): void {
    this.of(choices)();
  }

  /** Three numbers from -reach to reach. */
  vector(reach: number): [number, number, number] {
    return [this.between(-reach, reach), this.between(-reach, reach), this.between(-reach, reach)];
  }

  color(): number {
    return Math.floor(this.next() * 0xffffff);
  }
}
