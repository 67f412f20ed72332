import { shortText } from '@farol/editing';
import { counted } from '../../base/counted';
import { crc32 } from './crc32';
import { FileError } from '../FileError';
import { checkUnpacking, type MayUnpack, unpack, unpackLimits } from '../unpack';

const END = 0x06054b50;
const END_SIZE = 22;
const LONGEST_COMMENT = 0xffff;
const ENTRY = 0x02014b50;
const ENTRY_SIZE = 46;
const LOCAL = 0x04034b50;
const LOCAL_SIZE = 30;
const STORED = 0;
const DEFLATED = 8;
const IS_ENCRYPTED = 1;

interface Entry {
  readonly name: string;
  readonly method: number;
  /** CRC-32 of the entry's unpacked content. */
  readonly checksum: number;
  readonly packed: number;
  readonly unpacked: number;
  readonly at: number;
}

function fail(problem: string, cause?: unknown): never {
  throw new FileError([{ path: '', problem }], { cause });
}

const damaged = (reason: string, cause?: unknown): never =>
  fail(`The file is cut short or damaged (${reason}): open another copy of it.`, cause);

/** Reads the central directory of a ZIP. */
function readEntries(view: DataView<ArrayBuffer>): Entry[] {
  const size = view.byteLength;
  if (size < END_SIZE) damaged('its end is not there');
  const first = Math.max(0, size - END_SIZE - LONGEST_COMMENT);
  let end = size - END_SIZE;
  while (end >= first && view.getUint32(end, true) !== END) end--;
  if (end < first) damaged('its end is not there');
  const count = view.getUint16(end + 10, true);
  let at = view.getUint32(end + 16, true);
  if (count === 0xffff || at === 0xffffffff) fail('The ZIP is a ZIP64, made for more than 4 GB: make a smaller one.');
  if (count > unpackLimits.entries) {
    fail(`The ZIP holds ${counted(count)} files, and ${counted(unpackLimits.entries)} is the limit: split it.`);
  }
  const entries: Entry[] = [];
  for (let i = 0; i < count; i++) {
    if (at + ENTRY_SIZE > end || view.getUint32(at, true) !== ENTRY) damaged('its list of files is not whole');
    const [nameLength, extraLength, commentLength] = [28, 30, 32].map((offset) => view.getUint16(at + offset, true));
    const next = at + ENTRY_SIZE + nameLength + extraLength + commentLength;
    const local = view.getUint32(at + 42, true);
    if (next > end || local + LOCAL_SIZE > size) damaged('its list of files is not whole');
    if ((view.getUint16(at + 8, true) & IS_ENCRYPTED) !== 0) fail('The ZIP has a password: save it without one.');
    if (view.getUint32(local, true) !== LOCAL) damaged('a file is not where the list says');
    entries.push({
      name: new TextDecoder().decode(new Uint8Array(view.buffer, view.byteOffset + at + ENTRY_SIZE, nameLength)),
      method: view.getUint16(at + 10, true),
      checksum: view.getUint32(at + 16, true),
      packed: view.getUint32(at + 20, true),
      unpacked: view.getUint32(at + 24, true),
      at: local + LOCAL_SIZE + view.getUint16(local + 26, true) + view.getUint16(local + 28, true),
    });
    at = next;
  }
  return entries;
}

/**
 * Reads the files of a ZIP, deflated or stored. The total size is checked, and confirmed by the user, before anything
 * is unpacked, and checked again during unpacking; the result is checked against the CRC.
 * @throws FileError when the ZIP is damaged or beyond `unpackLimits`, AbortError when the user refused
 * @see PKWARE APPNOTE.TXT
 */
export async function readZip(
  bytes: Uint8Array<ArrayBuffer>,
  mayUnpack?: MayUnpack,
): Promise<Map<string, Uint8Array<ArrayBuffer>>> {
  const entries = readEntries(new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength));
  const files = new Map<string, Uint8Array<ArrayBuffer>>();
  let packed = 0;
  let unpacked = 0;
  for (const entry of entries) {
    packed += entry.packed;
    unpacked += entry.unpacked;
    if (entry.at + entry.packed > bytes.length) damaged('a file reaches beyond the end');
    if (entry.method !== STORED && entry.method !== DEFLATED)
      fail('The ZIP uses another method than Deflate: pack it again, with Deflate.');
    if (entry.method === STORED && entry.packed !== entry.unpacked) damaged('a file has two sizes');
    if (files.has(entry.name)) damaged('two files have one name');
    files.set(entry.name, bytes);
  }
  // if files overlap, their sizes add up to more than the ZIP has
  if (packed > bytes.length) damaged('its files overlap');
  await checkUnpacking({ packed: bytes.length, unpacked }, mayUnpack);
  for (const { name, method, checksum, at, packed: length, unpacked: exact } of entries) {
    let data = bytes.subarray(at, at + length);
    try {
      if (method === DEFLATED) data = await unpack(data, 'deflate-raw', { exact });
    } catch (cause) {
      damaged(`${shortText(name, 80)} in it cannot be unpacked`, cause);
    }
    if ((await crc32(data)) !== checksum) {
      fail(`The file is damaged (${shortText(name, 80)} in it is not what was packed): open another copy of it.`);
    }
    files.set(name, data);
  }
  return files;
}

/** Whether bytes are a ZIP with a file of this path; it is not unpacked. */
export function isInZip(bytes: Uint8Array<ArrayBuffer>, path: string): boolean {
  try {
    return readEntries(new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength)).some(
      ({ name }) => name === path,
    );
  } catch {
    // a damaged ZIP is reported by the caller, when unpacking it
    return false;
  }
}
