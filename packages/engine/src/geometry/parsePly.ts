import { shortText } from '@farol/editing';
import type { BufferGeometry } from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { FileError } from '../guard/FileError';
import { unpack } from '../guard/unpack';

/** Greatest size of a PLY header (bytes). */
const HEADER = 65_536;

const isGzip = (bytes: Uint8Array): boolean => bytes[0] === 0x1f && bytes[1] === 0x8b;

/** @throws Error when the data are too short for a count in the header, to which the loader would loop all the same */
function checkHeader(data: ArrayBuffer): void {
  const text = new TextDecoder('latin1').decode(new Uint8Array(data, 0, Math.min(HEADER, data.byteLength)));
  const end = text.search(/^end_header\b/m);
  if (end < 0) throw new Error('the header of the PLY file is incomplete: export it again');
  const elements: { name: string; count: string; properties: number }[] = [];
  for (const line of text.slice(0, end).split(/\r\n?|\n/)) {
    const [word, name = '', count = ''] = line.split(/\s+/, 3);
    if (word === 'element') elements.push({ name, count, properties: 0 });
    else if (word === 'property' && elements.length > 0) elements.at(-1)!.properties++;
  }
  let left = data.byteLength;
  for (const { name, count, properties } of elements) {
    // each property is at least one byte of the file
    left -= /^\d+$/.test(count) ? Number(count) * Math.max(1, properties) : Infinity;
    if (left >= 0) continue;
    throw new Error(
      `the PLY file is too short for ${shortText(count)} of the element ${shortText(name)}: export it again`,
    );
  }
}

/**
 * Reads a PLY mesh (ASCII or binary), gunzipped first when it is gzip. Normals stay absent when the file has none.
 * @throws Error that says what is missing or wrong
 */
export async function parsePly(data: ArrayBuffer): Promise<BufferGeometry> {
  let plain = data;
  if (isGzip(new Uint8Array(data, 0, Math.min(2, data.byteLength)))) {
    try {
      plain = (await unpack(new Uint8Array(data), 'gzip')).buffer;
    } catch (cause) {
      if (cause instanceof FileError) throw new Error(cause.problems[0].problem, { cause });
      throw new Error('the gzip data are damaged: export it again', { cause });
    }
  }
  const head = new TextDecoder().decode(new Uint8Array(plain, 0, Math.min(4, plain.byteLength)));
  if (!head.startsWith('ply'))
    throw new Error('the data are not a PLY file, which begins with "ply": choose another file');
  checkHeader(plain);
  let geometry: BufferGeometry;
  try {
    geometry = new PLYLoader().parse(plain);
  } catch (cause) {
    throw new Error('the PLY data are damaged or cut short: export it again', { cause });
  }
  const positions = geometry.getAttribute('position');
  if (!positions || positions.count === 0) throw new Error('the PLY file has no vertices: export it again');
  if (!geometry.index || geometry.index.count === 0) throw new Error('the PLY file has no faces: export it again');
  return geometry;
}
