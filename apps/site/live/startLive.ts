import { FarolRenderer } from '@farol/renderer';
import type { LiveModule } from './LiveModule';
import type { Still } from './still/holdStill';

declare global {
  interface Window {
    /** Runs the module by steps and compares its picture; in a page opened with `&still`. */
    still?: Still;
  }
}

/**
 * Late code that is fetched before a module runs, so that its first frame is drawn as it stays: without it, a first frame
 * is drawn by other programs, which takes a software rasteriser seconds. Node materials and XR sessions come when asked for.
 */
const PARTS = FarolRenderer.parts.filter((part) => part !== 'nodes' && part !== 'webxr');

/**
 * Runs the module that the query names, or says in the page why it cannot.
 * @param modules - each module's import, by its path from this folder
 */
export async function startLive(modules: Record<string, () => Promise<LiveModule>>): Promise<LiveModule> {
  const [name] = decodeURIComponent(location.search.slice(1)).split('&');
  const query = new URLSearchParams(location.search);
  const root = document.documentElement;
  root.dataset.theme = query.get('theme') ?? 'dark';
  root.lang = query.get('lang') ?? 'en';
  document.title = name;
  if (query.has('still')) {
    const { holdStill } = await import('./still/holdStill');
    window.still = await holdStill();
  }
  try {
    const load = modules[`./${name}.ts`] ?? modules[`./${name}.tsx`];
    if (load === undefined) throw new Error(`There is no live module ${JSON.stringify(name)}.`);
    await FarolRenderer.preload(PARTS);
    return await load();
  } catch (error) {
    tell(error instanceof Error ? error.message : String(error));
    throw error;
  }
}

function tell(message: string): void {
  const words = document.createElement('p');
  words.setAttribute('role', 'alert');
  words.textContent = message;
  document.body.replaceChildren(words);
}
