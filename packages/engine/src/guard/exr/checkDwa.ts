import { inflateBlock } from './inflateBlock';
import { runLengthSize } from './runLengthSize';

/** Count of the 8-byte numbers with which a block begins. */
const NUMBERS = 11;
const DEFLATE = 1;

const damaged = (): never => {
  throw new Error('a block of it is damaged');
};

/** Code lengths 59 to 62 stand for 2 to 5 zeros, 63 for 6 zeros plus the number in the next eight bits. */
const ZEROS = 59;
const MANY_ZEROS = 63;
const CODES = 65_537;

/** Offset of the first byte after Huffman codes, as three's EXRLoader parses them. */
function endOfCodes(bytes: Uint8Array<ArrayBuffer>, from: number): number {
  if (from + 20 > bytes.length) damaged();
  const view = new DataView(bytes.buffer, bytes.byteOffset + from);
  const [first, last, bits] = [0, 4, 12].map((offset) => view.getUint32(offset, true));
  if (last >= CODES) damaged();
  let at = (from + 20) * 8;
  const read = (count: number): number => {
    let value = 0;
    for (const end = at + count; at < end; at++) value = (value << 1) | ((bytes[at >> 3] >> (7 - (at & 7))) & 1);
    return value;
  };
  for (let code = first; code <= last && at < bytes.length * 8;) {
    const length = read(6);
    code += length === MANY_ZEROS ? read(8) + 6 : length >= ZEROS ? length - ZEROS + 2 : 1;
  }
  return Math.ceil(at / 8) + Math.ceil(bits / 8);
}

/**
 * Checks a DWA block: rules of channels, AC and DC coefficients, run lengths and raw bytes.
 * @param size - unpacked size of the block (bytes)
 * @see OpenEXR, ImfDwaCompressor.cpp
 */
export async function checkDwa(bytes: Uint8Array<ArrayBuffer>, size: number): Promise<void> {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < NUMBERS * 8 + 2) damaged();
  const numbers = Array.from({ length: NUMBERS }, (_, i) => Number(view.getBigUint64(i * 8, true)));
  const [, , , ac, dc, runs, runsUnpacked, raw, acCount, , acKind] = numbers;
  if (Math.max(runsUnpacked, raw, acCount) > size) damaged();
  let at = NUMBERS * 8;
  const rules = at + view.getUint16(at, true);
  if (rules > bytes.length) damaged();
  for (at += 2; at < rules;) {
    const end = bytes.indexOf(0, at);
    if (end < 0 || end + 3 > rules) damaged();
    at = end + 3;
  }
  const take = (length: number): Uint8Array<ArrayBuffer> => {
    if (length > bytes.length - at) damaged();
    return bytes.subarray(at, (at += length));
  };
  // of deflated AC coefficients, three's EXRLoader reads as many bytes as there are coefficients, not `ac` bytes
  if (ac > 0) {
    const packed = take(acKind === DEFLATE ? acCount : ac);
    if (acKind !== DEFLATE && endOfCodes(bytes, at - ac) !== at) damaged();
    if (acKind === DEFLATE) await inflateBlock(packed, { most: size });
  }
  if (dc > 0) await inflateBlock(take(dc), { most: size });
  if (raw > 0 && runLengthSize(await inflateBlock(take(runs), { most: size })) > size) damaged();
}
