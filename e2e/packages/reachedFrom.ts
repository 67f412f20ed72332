import { dirname, join, normalize } from 'node:path/posix';
import { parseSync } from 'vite';

/**
 * Follows imports from files of a package.
 *
 * @param files - text by path
 * @param atStart - follows static imports alone, not `import()`
 * @returns paths of the package that are reached, the starts among them, and the packages that they import; Node's own
 *   modules are none
 * @throws Error when a relative import leads to no file
 */
export function reachedFrom(
  files: ReadonlyMap<string, string>,
  starts: Iterable<string>,
  atStart = false,
): { paths: Set<string>; packages: Set<string> } {
  const paths = new Set(starts);
  const packages = new Set<string>();
  for (const path of paths) {
    const source = files.get(path);
    if (source === undefined) throw new Error(`${path} is imported, and is not in the package.`);
    for (const specifier of importsOf(path, source, atStart)) {
      if (specifier.startsWith('.')) paths.add(fileOf(path, specifier));
      else if (!specifier.startsWith('node:')) packages.add(/^(@[^/]+\/)?[^/]+/.exec(specifier)![0]);
    }
  }
  return { paths, packages };
}

/** A relative import of a declaration file names the script beside the other declaration file. */
function fileOf(path: string, specifier: string): string {
  const file = normalize(join(dirname(path), specifier));
  return path.endsWith('.d.ts') ? file.replace(/\.js$/, '.d.ts') : file;
}

/** Import specifiers of a file. @param atStart - static imports alone, not `import()` */
export function importsOf(path: string, source: string, atStart = false): string[] {
  const { module } = parseSync(path, source);
  return [
    ...module.staticImports.map(({ moduleRequest }) => moduleRequest.value),
    ...module.staticExports.flatMap(({ entries }) =>
      entries.flatMap(({ moduleRequest }) => (moduleRequest ? [moduleRequest.value] : [])),
    ),
    ...(atStart ? [] : module.dynamicImports).flatMap(({ moduleRequest: { start, end } }) => {
      const name = /^[`'"](.*)[`'"]$/.exec(source.slice(start, end));
      return name ? [name[1]] : [];
    }),
  ];
}
