import type { FileMap } from '../assets/collectFiles';
import { FileError } from './FileError';
import type { MayUnpack } from './unpack';

/** What programs leave in archives that is no file of anybody's. */
const isLitter = (path: string): boolean => /(^|\/)(__MACOSX\/|\.DS_Store$|Thumbs\.db$)/.test(path);

/**
 * Files with each ZIP among them replaced by what it holds, as if its folder had been dropped: 'sponza.zip' with
 * 'textures/wall.png' in it gives 'sponza/textures/wall.png'.
 * @param mayUnpack - asked before one becomes large; such a one is refused when absent. See `unpackLimits`
 * @throws Error (as a rejection) that names the ZIP and what is wrong with it; AbortError when `mayUnpack` answers no
 */
export async function expandZips(files: FileMap, mayUnpack?: MayUnpack): Promise<FileMap> {
  const zips = [...files.keys()].filter((path) => /\.zip$/i.test(path));
  if (zips.length === 0) return files;
  const all = new Map(files);
  const { readZip } = await import('./readZip');
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
      throw new Error(`${zip}: ${cause.problems[0].problem}`, { cause });
    }
  }
  return all;
}
