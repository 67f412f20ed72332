/** Number of distinguished depths, from the nearest light to the farthest. */
const KEYS = 4096;

/**
 * Counting sort of lights, near to far. Allocates only to grow; lights of equal depth, within 1 / KEYS of the range of depths,
 * keep their order.
 */
export class DepthOrder {
  private order = new Uint32Array(64);
  private keys = new Uint16Array(64);
  /** Number of lights of each depth, then the output index of the next such light. */
  private readonly places = new Uint32Array(KEYS);

  /**
   * @param count - number of lights
   * @param data - view-space z (m, negative before the camera) of light i at data[i * stride + offset]
   * @returns indices of the lights, nearest first; valid until the next call; at least `count` long
   */
  sort(count: number, data: ArrayLike<number>, stride: number, offset: number): Uint32Array {
    if (this.order.length < count) {
      this.order = new Uint32Array(count * 2);
      this.keys = new Uint16Array(count * 2);
    }
    const { keys, order, places } = this;
    let near = Infinity;
    let far = -Infinity;
    for (let i = 0; i < count; i++) {
      const depth = -data[i * stride + offset];
      if (depth < near) near = depth;
      if (depth > far) far = depth;
    }
    const scale = far > near ? (KEYS - 1) / (far - near) : 0;
    places.fill(0);
    for (let i = 0; i < count; i++) places[(keys[i] = ((-data[i * stride + offset] - near) * scale) | 0)]++;
    let sum = 0;
    for (let key = 0; key < KEYS; key++) {
      const lights = places[key];
      places[key] = sum;
      sum += lights;
    }
    for (let i = 0; i < count; i++) order[places[keys[i]]++] = i;
    return order;
  }
}
