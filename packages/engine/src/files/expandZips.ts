import { shortText } from '@farol/editing';
import type { FileMap } from '../assets/collectFiles';
import { FileError } from '../guard/FileError';
import type { MayUnpack } from '../guard/unpack';

/** Whether a path is a system file that archivers add, such as .DS_Store. */
const isLitter = (path: string): boolean => /(^|\/)(__MACOSX\/|\.DS_Store$|Thumbs\.db$)/.test(path);

/**
 * Replaces each ZIP among files by its content, as if a folder had been dropped: 'sponza.zip' with 'textures/wall.png'
 * in it gives 'sponza/textures/wall.png'.
 * @param mayUnpack - called before a large ZIP is unpacked; without it, large ones are refused. See `unpackLimits`
 * @param onProblem - called for a ZIP that cannot be read, which is then skipped
 * @throws Error (as a rejection) that names the ZIP and what is wrong with it, without `onProblem`; AbortError when
 *   `mayUnpack` returns false
 */
export async function expandZips(
  files: FileMap,
  mayUnpack?: MayUnpack,
  onProblem?: (problem: string) => void,
): Promise<FileMap> {
  const zips = [...files.keys()].filter((path) => /\.zip$/i.test(path));
  if (zips.length === 0) return files;
  const all = new Map(files);
  const { readZip } = await import('../guard/zip/readZip');
  for (const zip of zips) {
    all.delete(zip);
    try {
      const entries = await readZip(new Uint8Array(await files.get(zip)!.arrayBuffer()), mayUnpack);
      for (const [path, bytes] of entries) {
        if (path.endsWith('/') || isLitter(path)) continue;
        const whole = `${zip.replace(/\.zip$/i, '')}/${path.replaceAll('\\', '/')}`;
        all.set(whole, new File([bytes], whole.slice(whole.lastIndexOf('/') + 1)));
      }
    } catch (cause) {
      if (!(cause instanceof FileError)) throw cause;
      const problem = `${shortText(zip, 80)}: ${cause.problems[0].problem}`;
      if (!onProblem) throw new Error(problem, { cause });
      onProblem(problem);
    }
  }
  return all;
}
