import { t } from '@farol/editing';
import type { Viewer } from './Viewer';

/** Displays a message while the WebGL context is lost, and redraws once the browser restores it. */
export function watchContext(viewer: Viewer): void {
  const { canvas } = viewer.app;
  canvas.addEventListener('webglcontextlost', (event: Event) => {
    event.preventDefault(); // without preventDefault, the browser does not restore the context
    viewer.messages.show(
      'context',
      t('The graphics device was lost. The picture comes back by itself; if it does not, reload the page.'),
    );
  });
  canvas.addEventListener('webglcontextrestored', () => {
    viewer.messages.show('context', '');
    viewer.redraw();
  });
}
