import { DataTexture, DataUtils, HalfFloatType, LinearSRGBColorSpace, RGBAFormat } from 'three';
import { counted } from '../base/counted';
import { checkPixels } from '../guard/pictures/imageSize';

/** Narrowest row (pixels) that may be run-length encoded by channel. */
const LEAST_WIDTH = 8;
const MOST_WIDTH = 0x7fff;
/** Largest half float, to which brighter pixels are limited. */
const MOST = 65_504;

interface HdrHeader {
  /** Pixels of a scan line; `count` is the number of scan lines. Scan lines are columns where `isTurned`. */
  readonly length: number;
  readonly count: number;
  readonly isTurned: boolean;
  /** Whether the file's rows go from top to bottom; `goesRight`: whether its columns go from left to right. */
  readonly goesDown: boolean;
  readonly goesRight: boolean;
  /** Offset of the first byte after the header. */
  readonly end: number;
}

/** Reads the text header. @throws Error when the header is incomplete, or states another colour format */
function readHeader(bytes: Uint8Array): HdrHeader {
  let at = 0;
  const readLine = (): string => {
    const end = bytes.indexOf(10, at);
    if (end < 0) throw new Error('its header is incomplete');
    const line = String.fromCharCode(...bytes.subarray(at, Math.min(end, at + 1024)));
    at = end + 1;
    return line.replace(/\r$/, '');
  };
  for (let line = readLine(); line !== ''; line = readLine()) {
    const [, format] = /^\s*FORMAT\s*=\s*(\S+)/.exec(line) ?? [];
    if (format === '32-bit_rle_xyze') throw new Error('its colours are XYZ (32-bit_rle_xyze), and only RGB is read');
  }
  const size = /^\s*([-+])([XY])\s+(\d+)\s+([-+])([XY])\s+(\d+)\s*$/.exec(readLine());
  if (!size || size[2] === size[5]) throw new Error('its header gives no size');
  const [, firstSign, first, count, secondSign, , length] = size;
  const isTurned = first === 'X';
  const [signOfX, signOfY] = isTurned ? [firstSign, secondSign] : [secondSign, firstSign];
  return {
    length: Number(length),
    count: Number(count),
    isTurned,
    goesDown: signOfY === '-',
    goesRight: signOfX === '+',
    end: at,
  };
}

/** Half floats of all pairs of a mantissa (lower byte) and an exponent (upper byte). */
let halves: Uint16Array | null = null;
function halfTable(): Uint16Array {
  return (halves ??= Uint16Array.from({ length: 65_536 }, (_, i) =>
    DataUtils.toHalfFloat(Math.min(MOST, ((i & 255) * 2 ** ((i >> 8) - 128)) / 255)),
  ));
}

/** Reads the rows of a file, one after another. */
class RowReader {
  /** Red, green, blue and exponent of each pixel of the last row. */
  readonly row: Uint8Array;

  constructor(
    private readonly bytes: Uint8Array,
    private at: number,
    private readonly length: number,
  ) {
    this.row = new Uint8Array(length * 4);
  }

  /** Reads the next scan line. @throws Error when the scan line is incomplete */
  next(): void {
    const { bytes, at, length } = this;
    const isPacked =
      length >= LEAST_WIDTH &&
      length <= MOST_WIDTH &&
      bytes[at] === 2 &&
      bytes[at + 1] === 2 &&
      bytes[at + 2] === length >> 8 &&
      bytes[at + 3] === (length & 255);
    if (isPacked) this.readPacked();
    else this.readFlat();
  }

  /** Reads a scan line channel by channel, as runs and plain bytes. */
  private readPacked(): void {
    const { bytes, row, length } = this;
    let at = this.at + 4;
    for (let channel = 0; channel < 4; channel++) {
      for (let x = 0; x < length;) {
        const code = bytes[at++];
        const isRun = code > 128;
        const count = isRun ? code - 128 : code;
        // written so that undefined bytes beyond the end of the file fail the test
        if (!(count > 0 && x + count <= length && at + (isRun ? 1 : count) <= bytes.length))
          throw new Error('a row of it is cut short');
        for (const end = x + count; x < end; x++) row[x * 4 + channel] = isRun ? bytes[at] : bytes[at++];
        if (isRun) at++;
      }
    }
    this.at = at;
  }

  /**
   * Reads a scan line pixel by pixel. The pixel 1 1 1 n repeats the last pixel n times; if several such pixels follow
   * each other, the second counts n × 256 times, the third n × 65536.
   */
  private readFlat(): void {
    const { bytes, row, length } = this;
    let { at } = this;
    let scale = 1;
    for (let x = 0; x < length; at += 4) {
      if (at + 4 > bytes.length) throw new Error('a row of it is cut short');
      if (bytes[at] !== 1 || bytes[at + 1] !== 1 || bytes[at + 2] !== 1) {
        row.set(bytes.subarray(at, at + 4), x++ * 4);
        scale = 1;
        continue;
      }
      const count = bytes[at + 3] * scale;
      if (x === 0 || x + count > length) throw new Error('a row of it is damaged');
      for (const end = x + count; x < end; x++) row.copyWithin(x * 4, (x - 1) * 4, x * 4);
      scale *= 256;
    }
    this.at = at;
  }
}

/**
 * Reads a Radiance HDR as half floats, its first row at the top.
 * @throws PixelsError for one of absurd size; Error that says what is wrong with the bytes
 * @see Radiance File Formats, https://radsite.lbl.gov/radiance/refer/filefmts.pdf
 */
export function readHdr(bytes: Uint8Array): DataTexture {
  const { length, count, isTurned, goesDown, goesRight, end } = readHeader(bytes);
  const [width, height] = isTurned ? [count, length] : [length, count];
  checkPixels(width, height);
  const table = halfTable();
  const one = DataUtils.toHalfFloat(1);
  const reader = new RowReader(bytes, end, length);
  const data = new Uint16Array(width * height * 4);
  for (let i = 0; i < count; i++) {
    try {
      reader.next();
    } catch (cause) {
      throw new Error(`it has ${counted(i)} of ${counted(count)} rows`, { cause });
    }
    for (let j = 0; j < length; j++) {
      const [along, down] = isTurned ? [i, j] : [j, i];
      const x = goesRight ? along : width - 1 - along;
      const y = goesDown ? down : height - 1 - down;
      const exponent = reader.row[j * 4 + 3] << 8;
      const at = (y * width + x) * 4;
      for (let channel = 0; channel < 3; channel++) data[at + channel] = table[exponent | reader.row[j * 4 + channel]];
      data[at + 3] = one;
    }
  }
  const texture = new DataTexture(data, width, height, RGBAFormat, HalfFloatType);
  texture.colorSpace = LinearSRGBColorSpace;
  texture.flipY = true;
  return texture;
}
