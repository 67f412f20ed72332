import { BufferAttribute, BufferGeometry } from 'three';
import { Slices } from '../../base/Slices';
import { runInSlices, type Steps } from '../../base/steps';
import { counted } from '../../base/counted';
import { fileOfGeometry } from './fileOfGeometry';
import { LineReader } from './LineReader';
import { floatList } from './NumberList';
import type { ObjFile } from './parseObj';

const HEADER = 84;
const FACET = 50;

const isText = (bytes: Uint8Array): boolean => /^\W{0,5}solid/i.test(String.fromCharCode(...bytes.subarray(0, 16)));

/** Lines that are read before the generator yields: about a millisecond of work. */
const STEP = 4096;

/** @returns whether the file is text @throws Error of one sentence when a binary file is cut short */
function checkStl(bytes: Uint8Array): boolean {
  if (bytes.length < HEADER) throw new Error('it is cut short: an STL file has 84 bytes at least. Export it again.');
  const facets = new DataView(bytes.buffer, bytes.byteOffset).getUint32(80, true);
  const exact = HEADER + facets * FACET;
  if (exact === bytes.length) return false;
  if (isText(bytes)) return true;
  if (exact > bytes.length) {
    throw new Error(`its header says ${counted(facets)} triangles, and it is too short for them: export it again.`);
  }
  return false;
}

/** Parses the corners of a text STL. three's loader would search the rest of the file for each missing `endfacet`. */
function* parseText(bytes: Uint8Array): Steps<BufferGeometry> {
  const reader = new LineReader(bytes);
  const corners = floatList();
  // only a `vertex` within a loop counts, since the name of a solid may contain any words
  let isInLoop = false;
  while (!reader.isAtEnd) {
    for (let i = 0; i < STEP && !reader.isAtEnd; i++) {
      while (!reader.isLineOver) {
        const word = reader.word().toLowerCase();
        if (word === 'loop') isInLoop = true;
        else if (word === 'endloop') isInLoop = false;
        else if (isInLoop && word === 'vertex') corners.push3(reader.number(), reader.number(), reader.number());
      }
      reader.nextLine();
    }
    yield;
  }
  return new BufferGeometry().setAttribute('position', new BufferAttribute(corners.values, 3));
}

/**
 * Reads an STL file, binary or text. The file's face normals are ignored: normals are computed by crease angle.
 * @throws Error of one sentence that says what is wrong
 */
export async function parseStl(bytes: Uint8Array<ArrayBuffer>, signal?: AbortSignal): Promise<ObjFile> {
  const geometry = checkStl(bytes)
    ? await runInSlices(parseText(bytes), new Slices(signal))
    : new (await import('three/addons/loaders/STLLoader.js')).STLLoader().parse(bytes.buffer);
  const positions = geometry.getAttribute('position');
  if (!positions || positions.count < 3)
    throw new Error('it has no triangles: it is empty, or not an STL file. Export it again.');
  if (positions.array.some((value) => !Number.isFinite(value))) {
    throw new Error('it has positions that are not numbers: export it again.');
  }
  return runInSlices(fileOfGeometry(geometry, false), new Slices(signal));
}
