import { preloadFileCode } from '@farol/engine/files';
import { preloadSceneCode } from '@farol/scenes';

/** Resolves when the page is idle. */
const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: 3000 });
    else setTimeout(resolve, 300);
  });

/**
 * Fetches, once the page is idle, the code for selecting, copying, opening, dropping and saving, and the samples, which
 * the first frame does not need; nothing when the user has switched on the browser's data saver. A failure is ignored:
 * the code is then fetched when needed.
 *
 * @returns whether everything was fetched, so that these work offline
 */
export async function fetchAhead(): Promise<boolean> {
  if ((navigator as { connection?: { saveData?: boolean } }).connection?.saveData) return false;
  await idle();
  try {
    await Promise.all([
      preloadFileCode(),
      preloadSceneCode(),
      import('browser-fs-access'),
      import('./model/clip'),
      import('./model/groupObjects'),
      import('./viewport/pickBox'),
      import('./viewport/CameraFlight'),
      import('./viewport/SelectionLines'),
      import('./viewport/CameraPreview'),
      import('./viewport/MaterialBall'),
      import('./viewport/handles/DragAssist'),
      import('./viewport/handles/PoseDrag'),
      import('three/examples/jsm/controls/TransformControls.js'),
      import('./files/dropOn'),
      import('./files/landInPicture'),
      import('./files/readScene'),
      import('./files/share/openInLab'),
      import('./files/writeScene'),
      import('./files/thumbnails'),
      import('./panels/dialogs/TextDialog'),
      import('./panels/palette/CommandPalette'),
    ]);
    return true;
  } catch {
    // code that imports it later reports the failure
    return false;
  }
}
