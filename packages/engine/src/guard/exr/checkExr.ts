import { checkDwa } from './checkDwa';
import { inflateBlock } from './inflateBlock';
import { type ExrHeader, readExrHeader } from './readExrHeader';
import { runLengthSize } from './runLengthSize';

const [NONE, RLE, ZIPS, ZIP, PIZ, PXR24, DWAA] = [0, 1, 2, 3, 4, 5, 8];
/** Maximum size of the samples of one row of a deep picture (bytes). */
const DEEP = 2 ** 26;

const fail = (problem: string): never => {
  throw new Error(problem);
};

/** Checks the unpacked size of a block. @param size - expected size (bytes) */
async function checkBlock(bytes: Uint8Array<ArrayBuffer>, size: number, compression: number): Promise<void> {
  // a block that compression would not shrink is stored uncompressed
  if (bytes.length >= size) return;
  if (compression === NONE) fail('a block of it is cut short');
  if (compression === RLE && runLengthSize(bytes) !== size) fail('a block of it is damaged');
  if (compression === ZIPS || compression === ZIP) await inflateBlock(bytes, { exact: size });
  if (compression === PXR24) await inflateBlock(bytes, { most: size });
  if (compression === PIZ) checkPiz(bytes);
  if (compression >= DWAA) await checkDwa(bytes, size);
}

/**
 * Checks that Huffman codes end within a PIZ block; three's loader only limits the number of pixels that they decode
 * to.
 */
function checkPiz(bytes: Uint8Array<ArrayBuffer>): void {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const bitmap = bytes.length < 4 ? 0 : Math.max(0, view.getUint16(2, true) - view.getUint16(0, true) + 1);
  const at = 4 + bitmap;
  if (at + 4 > bytes.length || at + 4 + view.getUint32(at, true) > bytes.length) fail('a block of it is cut short');
}

/** Checks a row of a deep picture: the sample count of each pixel, and the samples. @returns size of the row (bytes) */
async function checkDeepRow(
  view: DataView<ArrayBuffer>,
  at: number,
  { compression, width }: ExrHeader,
): Promise<number> {
  if (at + 28 > view.byteLength) fail('a block of it is cut short');
  const sizes = [4, 12].map((offset) => Number(view.getBigUint64(at + offset, true)));
  let from = at + 28;
  for (const [i, size] of sizes.entries()) {
    if (size > view.byteLength - from) fail('a block of it is cut short');
    const bytes = new Uint8Array(view.buffer, from, size);
    const most = i === 0 ? width * 4 : DEEP;
    if (compression === RLE && runLengthSize(bytes) > most) fail('a block of it is damaged');
    if (compression === ZIPS && size > 0) await inflateBlock(bytes, { most });
    from += size;
  }
  return from - at;
}

/**
 * Checks an EXR before three's loader reads it, which allocates memory for any size that the file states.
 * @throws Error (as a rejection) that says what is wrong with the header or a block
 * @see OpenEXR file layout
 */
export async function checkExr(bytes: ArrayBuffer): Promise<void> {
  const header = readExrHeader(bytes);
  const { isTiled, isDeep, isMultiPart, block, blocks, table, top, pixel, compression } = header;
  const view = new DataView(bytes);
  const prefix = isMultiPart ? 4 : 0;
  const head = isTiled ? 20 : 8;
  /** Sum of the blocks' sizes (bytes); greater than the file if blocks overlap. */
  let sum = 0;
  let at = header.end + table * 8;
  if (at > bytes.byteLength) fail('its list of blocks is cut short');
  for (let i = 0; i < blocks; i++) {
    if (isDeep || isMultiPart) at = Number(view.getBigUint64(header.end + i * 8, true)) + prefix;
    if (at + head > bytes.byteLength) fail('a block of it is cut short');
    if (isDeep) sum += await checkDeepRow(view, at, header);
    else {
      const size = view.getUint32(at + head - 4, true);
      const left = isTiled ? view.getInt32(at, true) * block.width : 0;
      const row = isTiled ? view.getInt32(at + 4, true) * block.height : view.getInt32(at, true) - top;
      const columns = Math.min(block.width, header.width - left);
      const rows = Math.min(block.height, header.height - row);
      if (left < 0 || row < 0 || columns < 1 || rows < 1) fail('a block of it lies outside its picture');
      if (size > bytes.byteLength - at - head) fail('a block of it is cut short');
      await checkBlock(new Uint8Array(bytes, at + head, size), columns * rows * pixel, compression);
      at += head + size;
      sum += head + size;
    }
    if (sum > bytes.byteLength) fail('its blocks overlap');
  }
}
