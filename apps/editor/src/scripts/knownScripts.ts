import type { Scene, ScriptAsset } from '@farol/engine';

/** Key of localStorage with the last scripts that may run: hashes of all texts of a scene, and of each text. */
const KEY = 'farol-known-scripts';
const MOST = 400;

/** Hash of data; null when the browser cannot compute one. */
async function hashOf(data: unknown): Promise<string | null> {
  if (!globalThis.crypto?.subtle) return null;
  const bytes = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(JSON.stringify(data)));
  return Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

const scriptsOf = ({ assets }: Scene): ScriptAsset[] => assets.fieldAssets('script') as ScriptAsset[];

/** Hash of names and texts of all scripts of a scene. */
function hashOfAll(scene: Scene): Promise<string | null> {
  const texts = scriptsOf(scene).map(({ name, source }) => [name, source]);
  return hashOf(texts.toSorted((a, b) => (a[0] < b[0] ? -1 : 1)));
}

function known(): string[] {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(KEY) ?? '[]');
    return Array.isArray(list) ? list.filter((each) => typeof each === 'string') : [];
  } catch {
    return [];
  }
}

/** Whether the scripts of an opened scene may run: it has none, or the user has run or written the same set before. */
export async function mayRunScripts(scene: Scene): Promise<boolean> {
  if (scriptsOf(scene).length === 0) return true;
  const hash = await hashOfAll(scene);
  return hash !== null && known().includes(hash);
}

/** Whether scripts may run: the user has run or written each of these texts before, in any scene. */
export async function mayRunTexts(texts: readonly string[]): Promise<boolean> {
  const hashes = await Promise.all(texts.map(hashOf));
  const list = new Set(known());
  return hashes.every((hash) => hash !== null && list.has(hash));
}

/** Remembers that the scripts of a scene may run. */
export async function rememberScripts(scene: Scene): Promise<void> {
  const scripts = scriptsOf(scene);
  if (scripts.length === 0) return;
  const texts = scripts.map(({ source }) => source);
  const hashes = await Promise.all([hashOfAll(scene), ...texts.map(hashOf)]);
  const found = new Set(hashes.filter((hash) => hash !== null));
  if (found.size === 0) return;
  try {
    const others = known().filter((each) => !found.has(each));
    localStorage.setItem(KEY, JSON.stringify([...found, ...others].slice(0, MOST)));
  } catch {
    // without storage, the user is asked again next time
  }
}
