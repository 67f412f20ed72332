import { preloadFileCode } from '@farol/engine/files';
import { preloadSceneCode } from '@farol/engine/scenes';
import type { Editor } from '../Editor';

/** Once the page has nothing else to do. */
const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: 3000 });
    else setTimeout(resolve, 300);
  });

/**
 * Fetches, once the page is idle, the code that opening, dropping and saving files need, and the samples; the first frame
 * needs none of it. From then on these work without a network. What cannot be fetched now is fetched when it is needed.
 */
export async function fetchAhead(editor: Editor): Promise<void> {
  await idle();
  try {
    await Promise.all([
      preloadFileCode(),
      preloadSceneCode(),
      import('browser-fs-access'),
      import('./dropOn'),
      import('./readScene'),
      import('./saveFile'),
      import('../panels/dialogs/TextDialog'),
    ]);
    editor.worksOffline = true;
  } catch {
    // what needs the code says that it could not be fetched
  }
}
