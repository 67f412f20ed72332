import { SCENE_ENTRY } from './container';
import { FileError } from '../guard/FileError';
import { isInZip, readZip } from '../guard/zip/readZip';
import type { MayUnpack } from '../guard/unpack';

/** A scene file, unpacked: the text of the scene, and its other files. */
export interface SceneFile {
  readonly text: string;
  /** Bytes of a file in the container; null for none. */
  fileOf(path: string): Blob | null;
}

const textOf = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

const fail = (problem: string, cause?: unknown): never => {
  throw new FileError([{ path: '', problem }], { cause });
};

/** Whether bytes are a container of a scene, whatever the file's name; only its directory is read. */
export const isContainer = (bytes: Uint8Array<ArrayBuffer>): boolean => isInZip(bytes, SCENE_ENTRY);

/**
 * Reads a scene file: a `.farol` container, or plain JSON. `deserialize` checks the scene; pass it `fileOf` too.
 * @param mayUnpack - called before a large container is unpacked; without it, large ones are refused. See
 *   `unpackLimits`
 * @throws FileError (as a rejection) when the bytes are neither, are cut short, or become too large; AbortError when
 *   `mayUnpack` returns false
 */
export async function readSceneFile(bytes: Uint8Array, mayUnpack?: MayUnpack): Promise<SceneFile> {
  if (bytes.length === 0) fail('The file is empty: open another copy of it.');
  if (bytes[0] === 0x50 && bytes[1] === 0x4b) {
    const entries = await readZip(bytes as Uint8Array<ArrayBuffer>, mayUnpack);
    const scene = entries.get(SCENE_ENTRY);
    if (!scene) fail(`The ZIP holds no ${SCENE_ENTRY}: choose a .farol file, or drop models and textures on Assets.`);
    return {
      text: textOf(scene!),
      fileOf: (path) => (entries.has(path) ? new Blob([entries.get(path)!]) : null),
    };
  }
  if (textOf(bytes.subarray(0, 4)) === 'glTF') fail('The file is a GLB, not a scene of Farol: drop it on Assets.');
  return { text: textOf(bytes), fileOf: () => null };
}
