import { shortText } from '@farol/renderer';
import type { BufferGeometry } from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { FileError } from '../files/FileError';
import { unpack } from '../files/unpack';

/** Bytes in which a header ends. */
const HEADER = 65_536;

const isGzip = (bytes: Uint8Array): boolean => bytes[0] === 0x1f && bytes[1] === 0x8b;

/** @throws Error when an element of the header cannot be in the data: the loader would go through it all the same */
function checkHeader(data: ArrayBuffer): void {
  const text = new TextDecoder('latin1').decode(new Uint8Array(data, 0, Math.min(HEADER, data.byteLength)));
  const end = text.search(/^end_header\b/m);
  if (end < 0) throw new Error('the PLY file has no whole header');
  for (const [, name, count] of text.slice(0, end).matchAll(/^element\s+(\S+)\s+(\S+)/gm)) {
    if (/^\d+$/.test(count) && Number(count) <= data.byteLength) continue;
    throw new Error(`the PLY file cannot hold ${shortText(count)} of the element ${shortText(name)}: it is cut short`);
  }
}

/**
 * Reads a PLY mesh (ASCII or binary), gunzipped first when it is gzip. Normals stay absent when the file has none.
 * @throws Error saying what the data lack
 */
export async function parsePly(data: ArrayBuffer): Promise<BufferGeometry> {
  let plain = data;
  if (isGzip(new Uint8Array(data, 0, Math.min(2, data.byteLength)))) {
    try {
      plain = (await unpack(new Uint8Array(data), 'gzip')).buffer;
    } catch (cause) {
      if (cause instanceof FileError) throw new Error(cause.problems[0].problem, { cause });
      throw new Error('the gzip data are damaged', { cause });
    }
  }
  const head = new TextDecoder().decode(new Uint8Array(plain, 0, Math.min(4, plain.byteLength)));
  if (!head.startsWith('ply')) throw new Error('the data are no PLY file: they do not begin with "ply"');
  checkHeader(plain);
  let geometry: BufferGeometry;
  try {
    geometry = new PLYLoader().parse(plain);
  } catch (cause) {
    throw new Error('the PLY data are damaged or cut short: export it again', { cause });
  }
  const positions = geometry.getAttribute('position');
  if (!positions || positions.count === 0) throw new Error('the PLY file has no vertices');
  if (!geometry.index || geometry.index.count === 0) throw new Error('the PLY file has no faces');
  return geometry;
}
