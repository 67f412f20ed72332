const HEADER = 12;
const CHUNK = 8;

/** A length in bytes, rounded up to a multiple of 4. */
export const padded = (length: number): number => Math.ceil(length / 4) * 4;

/**
 * Makes a GLB of a glTF's JSON and its single buffer.
 * @param parts - the buffer; each part is padded to a multiple of 4 bytes
 * @param binaryLength - length of the parts with padding (bytes)
 * @see glTF 2.0, 4.4
 */
export function writeGlb(json: string, parts: readonly Uint8Array[], binaryLength: number): ArrayBuffer {
  const text = new TextEncoder().encode(json);
  const jsonLength = padded(text.length);
  const total = HEADER + CHUNK + jsonLength + (binaryLength > 0 ? CHUNK + binaryLength : 0);
  const glb = new ArrayBuffer(total);
  const view = new DataView(glb);
  const all = new Uint8Array(glb);
  [0x46546c67, 2, total, jsonLength, 0x4e4f534a].forEach((word, i) => view.setUint32(i * 4, word, true));
  all.fill(0x20, HEADER + CHUNK, HEADER + CHUNK + jsonLength);
  all.set(text, HEADER + CHUNK);
  if (binaryLength === 0) return glb;
  let at = HEADER + CHUNK + jsonLength;
  view.setUint32(at, binaryLength, true);
  view.setUint32(at + 4, 0x004e4942, true);
  at += CHUNK;
  for (const part of parts) {
    all.set(part, at);
    at += padded(part.length);
  }
  return glb;
}
