/** CRC-32 of bytes, as ZIP, PNG and gzip have it: by fflate, which computes it for files that it packs. */
export async function crc32(bytes: Uint8Array): Promise<number> {
  const { ZipPassThrough } = await import('three/addons/libs/fflate.module.js');
  const file = new ZipPassThrough('');
  file.ondata = () => {};
  file.push(bytes, true);
  return file.crc >>> 0;
}
