/** A file of an archive. */
export interface ZipEntry {
  /** ASCII alone. */
  readonly name: string;
  readonly bytes: Uint8Array<ArrayBuffer>;
}

/**
 * An archive of files as they are, uncompressed.
 *
 * @param date - of all files
 * @see APPNOTE.TXT 6.3.10, sections 4.3.7, 4.3.12 and 4.3.16
 */
export function writeZip(entries: readonly ZipEntry[], date: Date): Blob {
  const parts: Uint8Array<ArrayBuffer>[] = [];
  const directory: Uint8Array<ArrayBuffer>[] = [];
  let offset = 0;
  for (const { name, bytes } of entries) {
    const nameBytes = new TextEncoder().encode(name);
    // version needed, flags, method (stored), time, date, checksum, sizes, length of the name, no extra field
    const common = [
      ...[u16(10), u16(0), u16(0), u16(timeOf(date)), u16(dateOf(date))],
      ...[u32(checksum(bytes)), u32(bytes.length), u32(bytes.length), u16(nameBytes.length), u16(0)],
    ];
    const local = joined([u32(0x04034b50), ...common, nameBytes]);
    // version made by; then comment, disk and attributes, none of each, and where the file begins
    directory.push(joined([u32(0x02014b50), u16(10), ...common, new Uint8Array(10), u32(offset), nameBytes]));
    parts.push(local, bytes);
    offset += local.length + bytes.length;
  }
  const size = directory.reduce((sum, { length }) => sum + length, 0);
  const counts = [u16(entries.length), u16(entries.length)];
  const end = joined([u32(0x06054b50), u32(0), ...counts, u32(size), u32(offset), u16(0)]);
  return new Blob([...parts, ...directory, end], { type: 'application/zip' });
}

const u16 = (value: number): Uint8Array<ArrayBuffer> => new Uint8Array([value, value >> 8]);
const u32 = (value: number): Uint8Array<ArrayBuffer> =>
  new Uint8Array([value, value >>> 8, value >>> 16, value >>> 24]);

const timeOf = (date: Date): number => (date.getHours() << 11) | (date.getMinutes() << 5) | (date.getSeconds() >> 1);
const dateOf = (date: Date): number =>
  (Math.max(0, date.getFullYear() - 1980) << 9) | ((date.getMonth() + 1) << 5) | date.getDate();

function joined(parts: readonly Uint8Array<ArrayBuffer>[]): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** CRC-32. */
function checksum(bytes: Uint8Array): number {
  let crc = -1;
  for (const byte of bytes) {
    crc ^= byte;
    for (let bit = 0; bit < 8; bit++) crc = (crc >>> 1) ^ (crc & 1 ? 0xedb88320 : 0);
  }
  return ~crc >>> 0;
}
