/** CRC-32 of bytes, as in ZIP, PNG and gzip; computed by fflate, which needs it for the files that it packs. */
export async function crc32(bytes: Uint8Array): Promise<number> {
  const { ZipPassThrough } = await import('three/addons/libs/fflate.module.js');
  const file = new ZipPassThrough('');
  file.ondata = () => {};
  file.push(bytes, true);
  return file.crc >>> 0;
}
