import { unpack } from '../../guard/unpack';
import type { LightmapData } from './BakeData';

/** Mantissa bits dropped from each half float: a channel keeps a precision of 1/256. */
const DROPPED = 3;
/** Largest quantised channel value (12 bits), for the half float 65504. */
const LARGEST = 0x7bff >> DROPPED;
const PLANES = 6;

/** Compresses bytes by deflate. */
export async function deflate(bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array<ArrayBuffer>> {
  const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** @param length - expected size (bytes) @throws TypeError (as a rejection) for damaged bytes, and for another size */
export const inflate = (bytes: Uint8Array<ArrayBuffer>, length: number): Promise<Uint8Array<ArrayBuffer>> =>
  unpack(bytes, 'deflate-raw', { exact: length }).catch((cause: unknown) => {
    // browsers throw errors of different classes for damaged bytes
    throw new TypeError('the bytes are damaged', { cause });
  });

/**
 * Quantises a half float to 12 bits; 0 for negative values and NaN. Quantised values grow with the logarithm of the
 * channel.
 */
function quantised(half: number): number {
  if (half >= 0x8000 || half > 0x7c00) return 0;
  return Math.min((half + (1 << (DROPPED - 1))) >> DROPPED, LARGEST);
}

/** Prediction of a texel from its left, upper and upper-left neighbours. Weinberger et al., LOCO-I, 1996 */
function predicted(left: number, above: number, corner: number): number {
  if (corner >= Math.max(left, above)) return Math.min(left, above);
  if (corner <= Math.min(left, above)) return Math.max(left, above);
  return left + above - corner;
}

/** Prediction of a texel of a plane from its left, upper and upper-left neighbours, which must be known. */
function predictionAt(plane: Int32Array, i: number, x: number, y: number, width: number): number {
  if (y === 0) return x === 0 ? 0 : plane[i - 1];
  if (x === 0) return plane[i - width];
  return predicted(plane[i - 1], plane[i - width], plane[i - width - 1]);
}

/**
 * Packs a lightmap: channels of 12 bits, green and blue as differences from red, each texel as its difference from the
 * prediction by its neighbours, low and high bytes apart; deflated. A displayed value is off by at most 1/255, a
 * channel by 1/256 of its value.
 */
export function packLightmap({ width, height, data }: LightmapData): Promise<Uint8Array<ArrayBuffer>> {
  const count = width * height;
  const bytes = new Uint8Array(PLANES * count);
  const plane = new Int32Array(count);
  for (let c = 0; c < 3; c++) {
    for (let i = 0; i < count; i++) {
      const own = quantised(data[4 * i + c]);
      plane[i] = c === 0 ? own : own - quantised(data[4 * i]);
    }
    for (let y = 0, i = 0; y < height; y++) {
      for (let x = 0; x < width; x++, i++) {
        const rest = plane[i] - predictionAt(plane, i, x, y, width);
        const zigzag = rest < 0 ? -2 * rest - 1 : 2 * rest;
        bytes[2 * c * count + i] = zigzag & 255;
        bytes[(2 * c + 1) * count + i] = zigzag >> 8;
      }
    }
  }
  return deflate(bytes);
}

/** Unpacks the result of `packLightmap`. @throws TypeError when the bytes have the wrong size, or are damaged */
export async function unpackLightmap(
  packed: Uint8Array<ArrayBuffer>,
  width: number,
  height: number,
): Promise<LightmapData> {
  const count = width * height;
  const bytes = await inflate(packed, PLANES * count);
  const data = new Uint16Array(4 * count);
  const red = new Int32Array(count);
  const plane = new Int32Array(count);
  for (let c = 0; c < 3; c++) {
    for (let y = 0, i = 0; y < height; y++) {
      for (let x = 0; x < width; x++, i++) {
        const zigzag = bytes[2 * c * count + i] + 256 * bytes[(2 * c + 1) * count + i];
        const rest = zigzag & 1 ? -((zigzag + 1) >> 1) : zigzag >> 1;
        plane[i] = rest + predictionAt(plane, i, x, y, width);
        if (c === 0) red[i] = plane[i];
        const own = c === 0 ? plane[i] : red[i] + plane[i];
        data[4 * i + c] = Math.min(Math.max(own, 0), LARGEST) << DROPPED;
      }
    }
  }
  for (let i = 0; i < count; i++) data[4 * i + 3] = 0x3c00; // alpha is set to 1, as a half float
  return { width, height, data };
}
