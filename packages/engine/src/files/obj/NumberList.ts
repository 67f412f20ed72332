/** Numbers in a typed array that grows. */
export class NumberList<T extends Float32Array | Int32Array> {
  length = 0;

  constructor(
    private array: T,
    private readonly make: (size: number) => T,
  ) {}

  push3(a: number, b: number, c: number): void {
    if (this.length + 3 > this.array.length) this.grow();
    this.array[this.length++] = a;
    this.array[this.length++] = b;
    this.array[this.length++] = c;
  }

  push2(a: number, b: number): void {
    if (this.length + 2 > this.array.length) this.grow();
    this.array[this.length++] = a;
    this.array[this.length++] = b;
  }

  at(index: number): number {
    return this.array[index];
  }

  set(index: number, value: number): void {
    this.array[index] = value;
  }

  /** Numbers pushed so far. */
  get values(): T {
    return this.array.subarray(0, this.length) as T;
  }

  private grow(): void {
    const larger = this.make(this.array.length * 2);
    larger.set(this.array);
    this.array = larger;
  }
}

export const floatList = (): NumberList<Float32Array> =>
  new NumberList(new Float32Array(3072), (size) => new Float32Array(size));

export const integerList = (): NumberList<Int32Array> =>
  new NumberList(new Int32Array(3072), (size) => new Int32Array(size));
