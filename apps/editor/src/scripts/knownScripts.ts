import type { Scene, ScriptAsset } from '@farol/engine';

/** Where the browser keeps which scripts may run: hashes of all texts of a scene, the last ones. */
const KEY = 'farol-known-scripts';
const MOST = 200;

/** A hash of the texts of all scripts of a scene; null for one without, and where the browser cannot make one. */
async function hashOf({ assets }: Scene): Promise<string | null> {
  const scripts = assets.fieldAssets('script') as ScriptAsset[];
  if (scripts.length === 0 || !globalThis.crypto?.subtle) return null;
  const texts = scripts.map(({ name, source }) => [name, source]).toSorted((a, b) => (a[0] < b[0] ? -1 : 1));
  const bytes = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(JSON.stringify(texts)));
  return Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

function known(): string[] {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    return Array.isArray(list) ? list.filter((each) => typeof each === 'string') : [];
  } catch {
    return [];
  }
}

/** Whether the scripts of a scene that was opened may run: it has none, or the user has run or written the same ones before. */
export async function mayRunScripts(scene: Scene): Promise<boolean> {
  if (scene.assets.fieldAssets('script').length === 0) return true;
  const hash = await hashOf(scene);
  return hash !== null && known().includes(hash);
}

/** Remembers that scripts as those of a scene may run. */
export async function rememberScripts(scene: Scene): Promise<void> {
  const hash = await hashOf(scene);
  if (hash === null) return;
  try {
    const others = known().filter((each) => each !== hash);
    localStorage.setItem(KEY, JSON.stringify([hash, ...others].slice(0, MOST)));
  } catch {
    // without storage it is asked again
  }
}
