import { readdirSync, readFileSync } from 'node:fs';
import { basename, dirname, join, relative } from 'node:path';
import type { Dropped } from '../support/drop';

/** The glTF models below a folder, by their paths in it, in order of name. */
export function modelFiles(folder: string): string[] {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => /\.(glb|gltf)$/i.test(name))
    .sort();
}

/** Files that a user would drop to see a model: a GLB alone, a glTF with all that lies beside and below it. */
export function filesOf(path: string): Dropped {
  if (/\.glb$/i.test(path)) return { [basename(path)]: readFileSync(path) };
  const folder = dirname(path);
  const beside = readdirSync(folder, { recursive: true, withFileTypes: true }).filter(
    (entry) => entry.isFile() && (!/\.(glb|gltf)$/i.test(entry.name) || entry.name === basename(path)),
  );
  return Object.fromEntries(
    beside.map((entry) => {
      const file = join(entry.parentPath, entry.name);
      return [relative(folder, file), readFileSync(file)];
    }),
  );
}
