import type { EditorDocument } from '../model/EditorDocument';

/** Where a tab notes that scripts run. */
const KEY = 'farol-scripts-run';

/** How long scripts have been as they are before they are remembered (ms). */
const DELAY = 500;

/**
 * Notes in the tab while scripts run, so that a page that hung, and was reloaded, opens with scripts off; `?scripts=off` in the
 * address has them off too, as a frame of another page does. Scripts that run are remembered: a file with the same ones runs
 * them without a question.
 */
export function guardScripts(document: EditorDocument): void {
  const { scripts } = document;
  let timer: ReturnType<typeof setTimeout> | undefined;
  const hung = ofTab((store) => store.getItem(KEY)) === 'yes';
  const note = (): void => {
    clearTimeout(timer);
    if (!scripts.isOn || !scripts.areThere) {
      ofTab((store) => store.removeItem(KEY));
      return;
    }
    ofTab((store) => store.setItem(KEY, 'yes'));
    timer = setTimeout(() => void remember(document), DELAY);
  };
  if (globalThis.top !== globalThis.self) scripts.hold('framed');
  else if (new URLSearchParams(location.search).get('scripts') === 'off') scripts.hold('address');
  else if (hung) scripts.hold('hung');
  scripts.changed.subscribe(note);
  // a page that hangs, and is ended, does not come here
  addEventListener('pagehide', () => ofTab((store) => store.removeItem(KEY)));
  addEventListener('pageshow', note);
}

async function remember({ scene }: EditorDocument): Promise<void> {
  // without a network it is asked again
  const code = await import('./knownScripts').catch(() => null);
  await code?.rememberScripts(scene);
}

/** Reads or writes the tab's storage; null where the browser gives none, or has no room. */
function ofTab<T>(use: (store: Storage) => T): T | null {
  try {
    return use(sessionStorage);
  } catch {
    return null;
  }
}
