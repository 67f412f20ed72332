import { Slices } from '../../base/Slices';
import { runInSlices } from '../../base/steps';
import { parsePly } from '../../geometry/parsePly';
import { fileOfGeometry } from './fileOfGeometry';
import { type ObjFile, parseObj } from './parseObj';
import { parseStl } from './parseStl';

/** Reader of a file format that has meshes but no scene. */
interface MeshReader {
  /** Whether faces of the format name materials of MTL files. */
  readonly hasMaterials: boolean;
  /** @throws Error (as a rejection) of one sentence that says what is wrong; the signal's abort reason */
  read(bytes: Uint8Array<ArrayBuffer>, signal?: AbortSignal): Promise<ObjFile>;
}

/** Formats by the ending of the file's name. */
export const readers: Readonly<Record<string, MeshReader>> = {
  obj: { hasMaterials: true, read: (bytes, signal) => runInSlices(parseObj(bytes), new Slices(signal)) },
  stl: { hasMaterials: false, read: parseStl },
  ply: {
    hasMaterials: false,
    async read(bytes, signal) {
      const geometry = await parsePly(bytes.buffer);
      return runInSlices(fileOfGeometry(geometry, geometry.hasAttribute('normal')), new Slices(signal));
    },
  },
};

/** Reader of a file, by its extension. @throws Error when there is none */
export function readerOf(path: string): MeshReader {
  const ending = /\.(\w+)$/.exec(path)?.[1].toLowerCase() ?? '';
  if (!Object.hasOwn(readers, ending))
    throw new Error(`its type cannot be packed: choose .${Object.keys(readers).join(', .')}.`);
  return readers[ending];
}
