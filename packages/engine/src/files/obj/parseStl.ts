import { Slices } from '../../core/Slices';
import { runInSlices } from '../../core/steps';
import { counted } from '../../core/counted';
import { fileOfGeometry } from './fileOfGeometry';
import type { ObjFile } from './parseObj';

const HEADER = 84;
const FACET = 50;

const isText = (bytes: Uint8Array): boolean => /^\W{0,5}solid/.test(String.fromCharCode(...bytes.subarray(0, 16)));

/** @throws Error of one sentence when the loader would read beyond the end, or find nothing */
function checkStl(bytes: Uint8Array): void {
  if (bytes.length < HEADER) throw new Error('it is cut short: an STL file has 84 bytes at least. Export it again.');
  const facets = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  const exact = HEADER + facets * FACET;
  if (exact === bytes.length || isText(bytes)) return;
  if (exact > bytes.length) {
    throw new Error(`its header says ${counted(facets)} triangles, and it is too short for them: export it again.`);
  }
}

/**
 * Reads an STL file, binary or text. Its normals are those of the triangles: others are computed by crease angle.
 * @throws Error of one sentence that says what is wrong
 */
export async function parseStl(bytes: Uint8Array<ArrayBuffer>, signal?: AbortSignal): Promise<ObjFile> {
  checkStl(bytes);
  const { STLLoader } = await import('three/addons/loaders/STLLoader.js');
  const geometry = new STLLoader().parse(bytes.buffer);
  const positions = geometry.getAttribute('position');
  if (!positions || positions.count < 3) throw new Error('it has no triangles: it is no STL file, or an empty one.');
  if (positions.array.some((value) => !Number.isFinite(value))) {
    throw new Error('it has positions that are no numbers: export it again.');
  }
  return runInSlices(fileOfGeometry(geometry, false), new Slices(signal));
}
