import type { FileMap } from '../../assets/collectFiles';

/** Splits a path into parts, in lower case; `\` is a separator too. Drops `.`, `..`, drives and quotes. */
function partsOf(path: string): string[] {
  const parts: string[] = [];
  for (const part of path.replaceAll('\\', '/').replaceAll('"', '').toLowerCase().split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '.' && part !== '' && !/^[a-z]:$/.test(part)) parts.push(part);
  }
  return parts;
}

const stemOf = (name: string): string => name.replace(/\.\w+$/, '');

/** Greatest number of trailing path parts by which files are distinguished. */
const MOST_PARTS = 32;

/** Trailing parts of a path, the longest first: 'a/b/c', 'b/c', 'c'. */
function endsOf(parts: readonly string[]): string[] {
  const last = parts.slice(-MOST_PARTS);
  return last.map((_, i) => last.slice(i).join('/'));
}

/** Finds, among given files, those that OBJ and MTL files name, even if letter case, slashes or folders differ. */
export class ObjFolder {
  private readonly entries: readonly { readonly path: string; readonly parts: readonly string[] }[];
  /** First path of `files` for each full path as `partsOf` writes it, without differences of case and slashes. */
  private readonly wholes = new Map<string, string>();
  private readonly ends = new Map<string, string>();

  constructor(files: FileMap) {
    // without paths that name no file, such as 'a/..'
    this.entries = [...files.keys()]
      .map((path) => ({ path, parts: partsOf(path) }))
      .filter(({ parts }) => parts.length > 0);
    for (const { path, parts } of this.entries) {
      const whole = parts.join('/');
      if (!this.wholes.has(whole)) this.wholes.set(whole, path);
      for (const end of endsOf(parts)) if (!this.ends.has(end)) this.ends.set(end, path);
    }
  }

  /**
   * Path of the file that a reference means: relative to the folder of `from`, else the file of that name whose folders
   * agree best. Null when there is none.
   * @param from - path of the file that contains the reference
   * @param endings - extensions to accept in place of the reference's own, when no such file exists
   */
  find(from: string, reference: string, endings: readonly string[] = []): string | null {
    const folder = partsOf(from).slice(0, -1);
    const wanted = partsOf(reference);
    const name = wanted.at(-1);
    if (name === undefined) return null;
    const exact = partsOf([...folder, ...reference.replaceAll('\\', '/').split('/')].join('/')).join('/');
    const whole = this.wholes.get(exact);
    if (whole !== undefined) return whole;
    const others = endings.map((ending) => stemOf(name) + ending);
    for (const each of [name, ...others]) {
      const ends = endsOf([...wanted.slice(0, -1), each]);
      const found = ends.find((end) => this.ends.has(end));
      if (found !== undefined) return this.ends.get(found)!;
    }
    return null;
  }

  /** Paths of the files with this ending, files in the folder of `from` first. */
  ending(ending: string, from: string): string[] {
    const folder = partsOf(from).slice(0, -1);
    const isNear = (parts: readonly string[]): number => (parts.slice(0, -1).join('/') === folder.join('/') ? 0 : 1);
    return this.entries
      .filter(({ parts }) => parts.at(-1)!.endsWith(ending))
      .toSorted((a, b) => isNear(a.parts) - isNear(b.parts))
      .map(({ path }) => path);
  }
}
