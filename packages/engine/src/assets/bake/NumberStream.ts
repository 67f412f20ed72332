/** Writes whole numbers as bytes, small numbers in few: seven bits a byte, the sign in the last bit. */
export class NumberWriter {
  private bytes = new Uint8Array(1024);
  private length = 0;

  /** @param value - whole, -2³⁰ to 2³⁰ */
  write(value: number): void {
    let rest = value < 0 ? -2 * value - 1 : 2 * value;
    if (this.length + 5 > this.bytes.length) {
      const larger = new Uint8Array(2 * this.bytes.length);
      larger.set(this.bytes);
      this.bytes = larger;
    }
    for (; rest > 127; rest = Math.floor(rest / 128)) this.bytes[this.length++] = (rest & 127) | 128;
    this.bytes[this.length++] = rest;
  }

  /** Writes how each number differs from the one `stride` before it. */
  writeSteps(values: ArrayLike<number>, stride = 1): void {
    for (let i = 0; i < values.length; i++) this.write(values[i] - (i < stride ? 0 : values[i - stride]));
  }

  get result(): Uint8Array<ArrayBuffer> {
    return this.bytes.slice(0, this.length);
  }
}

/** Reads the bytes that a `NumberWriter` wrote. */
export class NumberReader {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get isAtEnd(): boolean {
    return this.at === this.bytes.length;
  }

  /** Reads the next number. @throws TypeError at the end of the bytes */
  read(): number {
    let rest = 0;
    for (let factor = 1; ; factor *= 128) {
      if (this.at >= this.bytes.length || factor > 2 ** 35) throw new TypeError('the numbers end too early');
      const byte = this.bytes[this.at++];
      rest += (byte & 127) * factor;
      if (byte < 128) break;
    }
    return rest % 2 === 1 ? -(rest + 1) / 2 : rest / 2;
  }

  /** @throws TypeError at the end of the bytes */
  readSteps(count: number, stride = 1): Float64Array {
    const values = new Float64Array(count);
    for (let i = 0; i < count; i++) values[i] = this.read() + (i < stride ? 0 : values[i - stride]);
    return values;
  }
}
