import type { FileMap } from '../../assets/collectFiles';

/** A path with `/`, small letters, and without `.`, `..` and what a drive or a quote adds. */
function partsOf(path: string): string[] {
  const parts: string[] = [];
  for (const part of path.replaceAll('\\', '/').replaceAll('"', '').toLowerCase().split('/')) {
    if (part === '..') parts.pop();
    else if (part !== '.' && part !== '' && !/^[a-z]:$/.test(part)) parts.push(part);
  }
  return parts;
}

const stemOf = (name: string): string => name.replace(/\.\w+$/, '');

/** How many parts of two paths agree, from their ends. */
function agreement(a: readonly string[], b: readonly string[]): number {
  let count = 0;
  while (count < a.length && count < b.length && a.at(-1 - count) === b.at(-1 - count)) count++;
  return count;
}

/** Finds what OBJ and MTL files name among dropped files: by other case, other slashes, another folder. */
export class ObjFolder {
  private readonly entries: readonly {
    readonly path: string;
    readonly parts: readonly string[];
    readonly file: File;
  }[];

  constructor(files: FileMap) {
    this.entries = [...files].map(([path, file]) => ({ path, parts: partsOf(path), file }));
  }

  /**
   * The path of the file that a reference means: the one from the folder of who names it, else the one of this name whose
   * path agrees most with it. Null when there is none.
   * @param from - path of the file that names it
   * @param endings - a file with one of these endings will do where there is none of the one that is named
   */
  find(from: string, reference: string, endings: readonly string[] = []): string | null {
    const folder = partsOf(from).slice(0, -1);
    const wanted = partsOf(reference);
    const name = wanted.at(-1);
    if (name === undefined) return null;
    const exact = partsOf([...folder, ...reference.replaceAll('\\', '/').split('/')].join('/')).join('/');
    const whole = this.entries.find(({ parts }) => parts.join('/') === exact);
    if (whole) return whole.path;
    const others = endings.map((ending) => stemOf(name) + ending);
    for (const each of [name, ...others]) {
      const path = [...wanted.slice(0, -1), each];
      const found = this.entries
        .filter(({ parts }) => parts.at(-1) === each)
        .toSorted((a, b) => agreement(b.parts, path) - agreement(a.parts, path));
      if (found.length > 0) return found[0].path;
    }
    return null;
  }

  /** Paths of the files that end so, those in the folder of `from` first. */
  ending(ending: string, from: string): string[] {
    const folder = partsOf(from).slice(0, -1);
    const isNear = (parts: readonly string[]): number => (parts.slice(0, -1).join('/') === folder.join('/') ? 0 : 1);
    return this.entries
      .filter(({ parts }) => parts.at(-1)!.endsWith(ending))
      .toSorted((a, b) => isNear(a.parts) - isNear(b.parts))
      .map(({ path }) => path);
  }
}
