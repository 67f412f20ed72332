import { shortText } from '@farol/editing';
import type { FileMap } from '../assets/collectFiles';
import { FileError } from '../guard/FileError';
import type { MayUnpack } from '../guard/unpack';

/** Whether a path is a system file that archivers add, such as .DS_Store. */
const isLitter = (path: string): boolean => /(^|\/)(__MACOSX\/|\.DS_Store$|Thumbs\.db$)/.test(path);

/**
 * Files with each ZIP among them replaced by what it holds, as if its folder had been dropped: 'sponza.zip' with
 * 'textures/wall.png' in it gives 'sponza/textures/wall.png'.
 * @param mayUnpack - asked before one becomes large; such a one is refused when absent. See `unpackLimits`
 * @param onProblem - told of a ZIP that cannot be read, which is left out then
 * @throws Error (as a rejection) that names the ZIP and what is wrong with it, where nobody is told; AbortError when
 * `mayUnpack` answers no
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
