import type { LiveModule } from './LiveModule';
import type { Still } from './still/holdStill';

declare global {
  interface Window {
    /** Runs the module by steps and compares its picture; missing in a page opened without `&still`. */
    still?: Still;
  }
}

/** Modules that draw in a worker, which fetches the renderer for itself. */
const DRAWN_IN_WORKERS = ['gallery/offscreen-canvas'];

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
    if (!DRAWN_IN_WORKERS.includes(name)) await (await import('./preloadRenderer')).preloadRenderer();
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
