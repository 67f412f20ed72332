/**
 * Runs one live module, named by the query: `?gallery/first-lamp`, `?thesis/…`, `?techniques/…`, then `&theme=light`,
 * `&lang=es`, `&still=2`.
 *
 * A module finds the page's `<canvas>`, draws, and may export `farol`, `webgl`, `scene` and `camera`, each as it is or as
 * a promise: `window.live` is fulfilled with what it exports. `still` holds the page's clock at so many seconds: see
 * still/StillClock.ts.
 */
import type { LiveModule } from './LiveModule';
import { startLive } from './startLive';

declare global {
  interface Window {
    /** Exports of the module, once it has run. */
    live: Promise<LiveModule>;
  }
}

const modules = import.meta.glob<LiveModule>(['./{gallery,thesis,techniques}/*.{ts,tsx}', '!./**/*.test.ts']);

window.live = startLive(modules);
