/** Unpacked size (bytes) of EXR run lengths: a negative count precedes literal bytes, any other a repeated byte. */
export function runLengthSize(bytes: Uint8Array): number {
  let size = 0;
  for (let at = 0; at < bytes.length;) {
    const count = (bytes[at] << 24) >> 24;
    size += count < 0 ? -count : count + 1;
    at += count < 0 ? 1 - count : 2;
  }
  return size;
}
