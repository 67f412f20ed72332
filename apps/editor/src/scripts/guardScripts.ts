import type { EditorDocument } from '../model/EditorDocument';

/** Key of sessionStorage that marks a tab in which scripts run. */
const KEY = 'farol-scripts-run';

/** Time without changes after which scripts are remembered (ms). */
const DELAY = 500;

/**
 * Marks the tab while scripts run, so that a page that hung and was reloaded opens with scripts off; `?scripts=off` in
 * the URL, or a frame of another page, switch scripts off too. Scripts that have run are remembered, so that files with
 * the same scripts run them without a question.
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
  // removes the mark when the page is left; not reached when a hanging page is killed, so that its mark stays
  addEventListener('pagehide', () => ofTab((store) => store.removeItem(KEY)));
  addEventListener('pageshow', note);
}

async function remember({ scene }: EditorDocument): Promise<void> {
  // offline the code may be missing: the question is asked again next time
  const code = await import('./knownScripts').catch(() => null);
  await code?.rememberScripts(scene);
}

/** Accesses sessionStorage; null when it is missing or full, or access throws. */
function ofTab<T>(use: (store: Storage) => T): T | null {
  try {
    return use(sessionStorage);
  } catch {
    return null;
  }
}
