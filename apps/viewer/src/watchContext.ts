import type { Viewer } from './Viewer';

/** Tells of a lost WebGL context, and draws again when the browser gives it back. */
export function watchContext(viewer: Viewer): void {
  const { canvas } = viewer.app;
  canvas.addEventListener('webglcontextlost', (event: Event) => {
    event.preventDefault(); // else the browser does not give it back
    const text = 'The graphics device was lost. The picture comes back by itself; if it does not, reload the page.';
    viewer.messages.show('context', text);
  });
  canvas.addEventListener('webglcontextrestored', () => {
    viewer.messages.show('context', '');
    viewer.redraw();
  });
}
