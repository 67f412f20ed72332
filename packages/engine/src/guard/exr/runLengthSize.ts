/** Bytes that run lengths come to, as EXR has them: a count below zero goes before bytes as they are, another before one that is repeated. */
export function runLengthSize(bytes: Uint8Array): number {
  let size = 0;
  for (let at = 0; at < bytes.length;) {
    const count = (bytes[at] << 24) >> 24;
    size += count < 0 ? -count : count + 1;
    at += count < 0 ? 1 - count : 2;
  }
  return size;
}
