const bits = new DataView(new ArrayBuffer(4));

/** The number of single precision before that of a positive time: where a step ends, since glTF has one value at a time. */
export function beforeTime(time: number): number {
  bits.setFloat32(0, time);
  bits.setUint32(0, bits.getUint32(0) - 1);
  return bits.getFloat32(0);
}
