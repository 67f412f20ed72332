/**
 * Sorts lights near to far. Allocates only to grow; radix sort of 16-bit depths, twice 8 bits, so that
 * lights of equal depth keep their order.
 */
export class DepthOrder {
  private order = new Uint32Array(64);
  private other = new Uint32Array(64);
  private keys = new Uint16Array(64);
  private readonly counts = new Uint32Array(256);

  /**
   * @param count - lights
   * @param data - view-space z (m, negative before the camera) of light i at data[i * stride + offset]
   * @returns indices of the lights, nearest first; valid until the next call; at least `count` long
   */
  sort(count: number, data: ArrayLike<number>, stride: number, offset: number): Uint32Array {
    this.reserve(count);
    const { keys } = this;
    let near = Infinity;
    let far = -Infinity;
    for (let i = 0; i < count; i++) {
      const depth = -data[i * stride + offset];
      if (depth < near) near = depth;
      if (depth > far) far = depth;
    }
    const scale = far > near ? 65535 / (far - near) : 0;
    for (let i = 0; i < count; i++) {
      keys[i] = (-data[i * stride + offset] - near) * scale;
      this.order[i] = i;
    }
    this.pass(count, 0);
    this.pass(count, 8);
    return this.order;
  }

  private pass(count: number, shift: number): void {
    const { counts, keys, order, other } = this;
    counts.fill(0);
    for (let i = 0; i < count; i++) counts[(keys[i] >> shift) & 255]++;
    let sum = 0;
    for (let i = 0; i < 256; i++) {
      const n = counts[i];
      counts[i] = sum;
      sum += n;
    }
    for (let k = 0; k < count; k++) {
      const i = order[k];
      other[counts[(keys[i] >> shift) & 255]++] = i;
    }
    this.order = other;
    this.other = order;
  }

  private reserve(count: number): void {
    if (this.order.length >= count) return;
    this.order = new Uint32Array(count * 2);
    this.other = new Uint32Array(count * 2);
    this.keys = new Uint16Array(count * 2);
  }
}
