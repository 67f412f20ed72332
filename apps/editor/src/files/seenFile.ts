import type { OpenFile } from '../api/EditorApi';

/** A mark of a file's bytes: equal for equal ones. */
export async function stampOf(bytes: Uint8Array | Blob): Promise<string> {
  const content = bytes instanceof Blob ? await bytes.arrayBuffer() : (bytes as Uint8Array<ArrayBuffer>);
  return new Uint8Array(await crypto.subtle.digest('SHA-256', content)).join();
}

/** A file with the mark of what was read of it, where it can be written to. Browsers that give handles make hashes. */
export const seenFile = async (bytes: Uint8Array | Blob, file: OpenFile): Promise<OpenFile> =>
  file.handle ? { ...file, seen: await stampOf(bytes) } : file;
