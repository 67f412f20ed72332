import { preloadFileCode } from '@farol/engine/files';
import { preloadSceneCode } from '@farol/scenes';

/** Once the page has nothing else to do. */
const idle = (): Promise<void> =>
  new Promise((resolve) => {
    if ('requestIdleCallback' in window) requestIdleCallback(() => resolve(), { timeout: 3000 });
    else setTimeout(resolve, 300);
  });

/**
 * Fetches, once the page is idle, the code that opening, dropping and saving files need, and the samples; the first frame
 * needs none of it. What cannot be fetched now is fetched when it is needed.
 * @returns whether all was fetched, so that opening, dropping and saving work without a network
 */
export async function fetchAhead(): Promise<boolean> {
  await idle();
  try {
    await Promise.all([
      preloadFileCode(),
      preloadSceneCode(),
      import('browser-fs-access'),
      import('./files/dropOn'),
      import('./files/landInPicture'),
      import('./files/readScene'),
      import('./files/writeScene'),
      import('./files/thumbnails'),
      import('./panels/dialogs/TextDialog'),
      import('./panels/palette/CommandPalette'),
      import('./viewport/MaterialBall'),
    ]);
    return true;
  } catch {
    // what needs the code says that it could not be fetched
    return false;
  }
}
