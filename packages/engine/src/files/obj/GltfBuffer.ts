import { padded } from '../writeGlb';

/** Builder of a GLB's single buffer, with its views and accessors. */
export class GltfBuffer {
  readonly parts: Uint8Array[] = [];
  readonly views: object[] = [];
  readonly accessors: object[] = [];
  length = 0;

  /** Appends bytes. @returns index of their buffer view */
  addBytes(bytes: Uint8Array, target?: 34962 | 34963): number {
    const view = { buffer: 0, byteOffset: this.length, byteLength: bytes.length, ...(target ? { target } : {}) };
    this.parts.push(bytes);
    this.length += padded(bytes.length);
    return this.views.push(view) - 1;
  }

  /**
   * Adds a vertex attribute.
   * @param bounds - whether to store minimum and maximum, which glTF requires for positions
   * @returns index of its accessor
   */
  addVertices(values: Float32Array, size: 2 | 3, bounds = false): number {
    const bufferView = this.addBytes(new Uint8Array(values.buffer, values.byteOffset, values.byteLength), 34962);
    const accessor = { bufferView, componentType: 5126, count: values.length / size, type: `VEC${size}` };
    return this.accessors.push(bounds ? { ...accessor, ...boundsOf(values, size) } : accessor) - 1;
  }

  /**
   * Adds triangle indices.
   * @param vertices - number of vertices
   * @returns index of the accessor
   */
  addIndex(index: Uint32Array, vertices: number): number {
    // the largest value of an index type restarts a primitive, so it cannot be an index
    const short = vertices < 0xffff ? new Uint16Array(index) : null;
    const bufferView = this.addBytes(short ? new Uint8Array(short.buffer) : new Uint8Array(index.buffer), 34963);
    return (
      this.accessors.push({ bufferView, componentType: short ? 5123 : 5125, count: index.length, type: 'SCALAR' }) - 1
    );
  }
}

function boundsOf(values: Float32Array, size: number): { min: number[]; max: number[] } {
  const min = Array.from({ length: size }, () => Infinity);
  const max = Array.from({ length: size }, () => -Infinity);
  for (let i = 0; i < values.length; i++) {
    const k = i % size;
    if (values[i] < min[k]) min[k] = values[i];
    if (values[i] > max[k]) max[k] = values[i];
  }
  return { min, max };
}
