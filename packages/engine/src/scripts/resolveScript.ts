/** Resolves `.` and `..` in a path; null when it leads above the top folder. */
function normalised(path: string): string | null {
  const parts: string[] = [];
  for (const part of path.split('/')) {
    if (part === '..') {
      if (parts.pop() === undefined) return null;
    } else if (part !== '.' && part !== '') parts.push(part);
  }
  return parts.join('/');
}

/**
 * Name of the script that an import such as './helpers' or '../tools/helpers' means, relative to the importing script's
 * folder; null when there is none.
 */
export function resolveScript(specifier: string, from: string, has: (name: string) => boolean): string | null {
  const folder = from.slice(0, from.lastIndexOf('/') + 1);
  const path = normalised(folder + specifier);
  if (path === null) return null;
  const bare = path.replace(/\.(ts|js)$/, '');
  return [path, `${path}.ts`, `${path}.js`, bare, `${bare}.ts`].find(has) ?? null;
}
