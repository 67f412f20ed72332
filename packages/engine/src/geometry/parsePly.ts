import type { BufferGeometry } from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';

const isGzip = (bytes: Uint8Array): boolean => bytes[0] === 0x1f && bytes[1] === 0x8b;

async function gunzip(data: ArrayBuffer): Promise<ArrayBuffer> {
  const stream = new Blob([data]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

/**
 * Reads a PLY mesh (ASCII or binary), gunzipped first when it is gzip. Normals stay absent when the file has none.
 * @throws Error saying what the data lack
 */
export async function parsePly(data: ArrayBuffer): Promise<BufferGeometry> {
  let plain = data;
  if (isGzip(new Uint8Array(data, 0, Math.min(2, data.byteLength)))) {
    try {
      plain = await gunzip(data);
    } catch (cause) {
      throw new Error('the gzip data are damaged', { cause });
    }
  }
  const head = new TextDecoder().decode(new Uint8Array(plain, 0, Math.min(4, plain.byteLength)));
  if (!head.startsWith('ply')) throw new Error('the data are no PLY file: they do not begin with "ply"');
  const geometry = new PLYLoader().parse(plain);
  const positions = geometry.getAttribute('position');
  if (!positions || positions.count === 0) throw new Error('the PLY file has no vertices');
  if (!geometry.index || geometry.index.count === 0) throw new Error('the PLY file has no faces');
  return geometry;
}
