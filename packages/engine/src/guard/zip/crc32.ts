/** Of each byte, what it does to the checksum with none to seven bytes after it. */
const tables = Array.from({ length: 8 }, () => new Uint32Array(256));
for (let byte = 0; byte < 256; byte++) {
  let c = byte;
  for (let bit = 0; bit < 8; bit++) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  tables[0][byte] = c;
}
for (let after = 1; after < 8; after++) {
  for (let byte = 0; byte < 256; byte++) {
    const c = tables[after - 1][byte];
    tables[after][byte] = tables[0][c & 0xff] ^ (c >>> 8);
  }
}

/**
 * The CRC-32 of bytes, as ZIP, PNG and gzip have it: eight bytes at a time.
 * @see Kounavis and Berry 2005, A systematic approach to building high performance software-based CRC generators
 */
export function crc32(bytes: Uint8Array): number {
  const [t0, t1, t2, t3, t4, t5, t6, t7] = tables;
  const eights = bytes.length - (bytes.length % 8);
  let c = 0xffffffff;
  let i = 0;
  for (; i < eights; i += 8) {
    c ^= bytes[i] | (bytes[i + 1] << 8) | (bytes[i + 2] << 16) | (bytes[i + 3] << 24);
    c =
      t7[c & 0xff] ^
      t6[(c >>> 8) & 0xff] ^
      t5[(c >>> 16) & 0xff] ^
      t4[c >>> 24] ^
      t3[bytes[i + 4]] ^
      t2[bytes[i + 5]] ^
      t1[bytes[i + 6]] ^
      t0[bytes[i + 7]];
  }
  for (; i < bytes.length; i++) c = t0[(c ^ bytes[i]) & 0xff] ^ (c >>> 8);
  return (c ^ 0xffffffff) >>> 0;
}
