import type { OpenFile } from '../api/EditorApi';

/** Hash of a file's bytes. */
export async function stampOf(bytes: Uint8Array | Blob): Promise<string> {
  const content = bytes instanceof Blob ? await bytes.arrayBuffer() : (bytes as Uint8Array<ArrayBuffer>);
  return new Uint8Array(await crypto.subtle.digest('SHA-256', content)).join();
}

/** Adds the hash of a file's bytes when the file can be written to. Browsers with file handles also support hashing. */
export const seenFile = async (bytes: Uint8Array | Blob, file: OpenFile): Promise<OpenFile> =>
  file.handle ? { ...file, seen: await stampOf(bytes) } : file;
