import { type Command, SetFields } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { resolveScript } from '@farol/engine/scripts';
import { splitName } from './assetNames';

/** Matches the relative specifier of an import, an export or a call of `require` or `import`. */
const IMPORT = /(\b(?:from|import|require)\s*\(?\s*)(['"])(\.{1,2}\/[^'"\n]+)\2/g;

/** Specifier with which a script in a folder imports another. @param folder - '' for the top */
function specifierOf(folder: string, target: string): string {
  const from = folder === '' ? [] : folder.split('/');
  const to = target.split('/');
  let shared = 0;
  while (shared < from.length && shared < to.length - 1 && from[shared] === to[shared]) shared++;
  const up = from.length - shared;
  return (up === 0 ? './' : '../'.repeat(up)) + to.slice(shared).join('/');
}

/**
 * Text of a script with imports adapted to renamed scripts.
 * @param name - name of the script before the renaming
 * @param renames - old to new names, including the script's own when it is renamed
 * @param isScript - whether a script of this name existed before the renaming
 */
export function sourceWithImports(
  source: string,
  name: string,
  renames: ReadonlyMap<string, string>,
  isScript: (name: string) => boolean,
): string {
  const { folder } = splitName(renames.get(name) ?? name);
  const isMoved = folder !== splitName(name).folder;
  return source.replace(IMPORT, (all, start: string, quote: string, specifier: string) => {
    const target = resolveScript(specifier, name, isScript);
    if (target === null || !(isMoved || renames.has(target))) return all;
    const next = specifierOf(folder, renames.get(target) ?? target);
    const hasEnding = /\.(ts|js)$/.test(specifier);
    return start + quote + (hasEnding ? next : next.replace(/\.(ts|js)$/, '')) + quote;
  });
}

export function importsOf(source: string, name: string, isScript: (name: string) => boolean): string[] {
  return [...source.matchAll(IMPORT)].flatMap(([, , , specifier]) => resolveScript(specifier, name, isScript) ?? []);
}

/**
 * Texts of scripts whose imports change when assets are renamed, by the scripts' old names.
 * @param renames - old to new names of assets of any kind
 * @param sources - texts used in place of those in the scene. Default none
 */
export function sourcesAfterRename(
  scene: Scene,
  renames: ReadonlyMap<string, string>,
  sources: ReadonlyMap<string, string> = new Map(),
): Map<string, string> {
  const after = new Map(sources);
  const { assets } = scene;
  const isScript = (name: string): boolean => assets.fieldAsset(name)?.type === 'script';
  for (const script of assets.fieldAssets('script')) {
    const { name } = script;
    const before = sources.get(name) ?? (script.get('source') as string);
    const text = sourceWithImports(before, name, renames, isScript);
    if (text !== before) after.set(name, text);
  }
  return after;
}

/** Commands that set the texts of `sourcesAfterRename`; made before the renaming. */
export function setSources(scene: Scene, label: string, sources: ReadonlyMap<string, string>): (() => Command)[] {
  return [...sources].flatMap(([name, value]) => {
    const owner = scene.assets.fieldAsset(name);
    if (owner === null || owner.get('source') === value) return [];
    return [() => new SetFields(label, [{ owner, name: 'source', value }])];
  });
}
