import { counted } from '../../base/counted';
import { checkPixels } from '../pictures/imageSize';

const BEGIN = 8;
const [TILED, DEEP, MULTI_PART] = [0x200, 0x800, 0x1000];
/** Bytes of attributes by type: three's loader assumes these, whatever size an attribute states. */
const SIZES: Readonly<Record<string, number>> = {
  box2i: 16,
  chromaticities: 32,
  compression: 1,
  envmap: 1,
  float: 4,
  int: 4,
  lineOrder: 1,
  rational: 8,
  tiledesc: 9,
  timecode: 8,
  v2f: 8,
  v3f: 12,
};
/** Maximum number of samples of a picture, of bytes of a block, and of blocks. */
const SAMPLES = 2 ** 30;
const BLOCK = 2 ** 28;
const BLOCKS = 2 ** 15;

/** Rows per block by compression, as in three: none, RLE, ZIPS, ZIP, PIZ, PXR24, B44, B44A, DWAA, DWAB. */
const ROWS = [1, 1, 1, 16, 32, 16, 32, 32, 32, 256];

/** Header of the first part of an EXR, the only one that is read. */
export interface ExrHeader {
  readonly width: number;
  readonly height: number;
  /** y of the picture's first row. */
  readonly top: number;
  /** Compression method of the EXR file, an index of `ROWS`. */
  readonly compression: number;
  /** Bytes of a decompressed pixel. */
  readonly pixel: number;
  readonly isTiled: boolean;
  readonly isDeep: boolean;
  readonly isMultiPart: boolean;
  /** Pixels of a block, or of a tile. */
  readonly block: { readonly width: number; readonly height: number };
  /** Number of compressed blocks of rows in the picture. */
  readonly blocks: number;
  /** Number of offsets in the table of blocks, tiles of smaller levels included. */
  readonly table: number;
  /** Offset of the first byte after the headers. */
  readonly end: number;
}

type Attributes = Map<string, { readonly type: string; readonly at: number; readonly size: number }>;

const fail = (problem: string): never => {
  throw new Error(problem);
};
const cut = (): never => fail('its header is incomplete');

/** Reads the attributes of each part, and the offset of the byte after them. */
function readAttributes(view: DataView): { parts: Attributes[]; end: number } {
  const all = new Uint8Array(view.buffer);
  let at = BEGIN;
  const readText = (): string => {
    const end = all.indexOf(0, at);
    if (end < 0) cut();
    const text = String.fromCharCode(...all.subarray(at, Math.min(end, at + 32)));
    at = end + 1;
    return text;
  };
  if (all.length < BEGIN + 1) cut();
  const isMultiPart = (view.getUint32(4, true) & MULTI_PART) !== 0;
  const parts: Attributes[] = [];
  let part: Attributes = new Map();
  for (;;) {
    const name = readText();
    if (name === '') {
      // an empty name ends each part; with several parts, one more empty name ends the list
      if (part.size > 0) parts.push(part);
      if (!isMultiPart || part.size === 0) break;
      part = new Map();
      continue;
    }
    const type = readText();
    if (at + 4 > all.length) cut();
    const size = view.getInt32(at, true);
    at += 4;
    if (size < 0 || at + size > all.length) cut();
    if (Object.hasOwn(SIZES, type) && SIZES[type] !== size) fail(`its attribute ${name} is of the wrong size`);
    part.set(name, { type, at, size });
    at += size;
  }
  return { parts, end: at };
}

/** Size of a pixel (bytes) as three computes it, and the number of channels. @see OpenEXR file layout: chlist */
function readChannels(view: DataView, from: number, size: number): { pixel: number; count: number } {
  const all = new Uint8Array(view.buffer, from, size);
  let pixel = 0;
  let count = 0;
  for (let at = 0; all[at] !== 0; count++) {
    const end = all.indexOf(0, at) + 1;
    if (end === 0 || end + 16 >= size) cut();
    const type = view.getUint32(from + end, true);
    if (type > 2) fail('a channel of it has an unknown type');
    pixel += type * 2;
    at = end + 16;
  }
  return { pixel, count };
}

/**
 * Reads the header of an EXR. three's loader never ends on a truncated header, and allocates whatever size a header
 * states.
 * @throws Error when the header is not whole, or the picture, its tiles or blocks are of absurd size
 * @see OpenEXR file layout: attributes of name, type, size and value, an empty name at the end
 */
export function readExrHeader(bytes: ArrayBuffer): ExrHeader {
  const view = new DataView(bytes);
  const { parts, end } = readAttributes(view);
  const flags = view.getUint32(4, true);
  const [isTiled, isDeep, isMultiPart] = [TILED, DEEP, MULTI_PART].map((flag) => (flags & flag) !== 0);
  for (const part of parts) {
    const window = part.get('dataWindow');
    if (window?.type === 'box2i') {
      const [left, top, right, bottom] = [0, 4, 8, 12].map((offset) => view.getInt32(window.at + offset, true));
      checkPixels(right - left + 1, bottom - top + 1);
    }
    const tiles = part.get('tiles');
    if (tiles?.type === 'tiledesc') checkPixels(view.getUint32(tiles.at, true), view.getUint32(tiles.at + 4, true));
  }
  const attribute = (name: string, type: string): { at: number; size: number } => {
    const found = parts[0]?.get(name);
    return found?.type === type ? found : fail(`its header has no ${name}`);
  };
  const window = attribute('dataWindow', 'box2i').at;
  const [left, top, right, bottom] = [0, 4, 8, 12].map((offset) => view.getInt32(window + offset, true));
  const [width, height] = [right - left + 1, bottom - top + 1];
  if (width < 1 || height < 1) fail('it has no pixels');
  const compression = view.getUint8(attribute('compression', 'compression').at);
  if (compression >= ROWS.length) fail('it is compressed in an unknown way');
  const channels = attribute('channels', 'chlist');
  const { pixel, count } = readChannels(view, channels.at, channels.size);
  const block = { width, height: ROWS[compression] };
  let blocks = Math.ceil(height / block.height);
  let table = blocks;
  if (isDeep || isMultiPart) {
    if (isTiled) fail('it has tiles in several parts');
    const chunks = view.getInt32(attribute('chunkCount', 'int').at, true);
    if (chunks !== blocks) fail('the number of its blocks does not fit its rows');
    table = parts.reduce((sum, part) => {
      const own = part.get('chunkCount');
      return sum + (own?.type === 'int' ? Math.max(0, view.getInt32(own.at, true)) : 0);
    }, 0);
  } else if (isTiled) {
    const tiles = attribute('tiles', 'tiledesc').at;
    block.width = view.getUint32(tiles, true);
    block.height = view.getUint32(tiles + 4, true);
    const mode = view.getUint8(tiles + 8);
    if (block.width < 1 || block.height < 1 || (mode & 15) > 1 || mode >> 4 > 1)
      fail('its tiles are of an unknown kind');
    ({ blocks, table } = tileCounts({ width, height }, block, mode));
  }
  const most = Math.min(block.width, width) * Math.min(block.height, height) * count * 4;
  if (width * height * count > SAMPLES || most > BLOCK || blocks > BLOCKS) {
    fail(`${counted(count)} channels in ${counted(blocks)} blocks are more than is read`);
  }
  return { ...{ width, height, top, compression, pixel, isTiled, isDeep, isMultiPart, block, blocks, table }, end };
}

type Size = { readonly width: number; readonly height: number };

/**
 * Number of tiles of the full-size picture (`blocks`), and of all its levels together (`table`).
 * @param mode - levels in its lower four bits, rounding in its upper ones
 */
function tileCounts({ width, height }: Size, tile: Size, mode: number): { blocks: number; table: number } {
  const round = mode >> 4 === 1 ? Math.ceil : Math.floor;
  const levels = (mode & 15) === 0 ? 1 : round(Math.log2(Math.max(width, height))) + 1;
  const along = (size: number, of: number, level: number): number =>
    Math.ceil(Math.max(1, round(size / 2 ** level)) / of);
  const counts = Array.from({ length: levels }, (_, i) => along(width, tile.width, i) * along(height, tile.height, i));
  return { blocks: counts[0], table: counts.reduce((sum, count) => sum + count, 0) };
}
