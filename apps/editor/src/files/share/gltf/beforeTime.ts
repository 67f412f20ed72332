const bits = new DataView(new ArrayBuffer(4));

/** The largest 32-bit float below a positive time: the end of a step, since glTF allows one value per time. */
export function beforeTime(time: number): number {
  bits.setFloat32(0, time);
  bits.setUint32(0, bits.getUint32(0) - 1);
  return bits.getFloat32(0);
}
