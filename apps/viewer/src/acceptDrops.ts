import { collectFiles } from '@farol/engine/files';
import type { Viewer } from './Viewer';

/** Accepts files and folders dropped anywhere on the window. */
export function acceptDrops(viewer: Viewer): void {
  const over = (event: DragEvent) => {
    event.preventDefault();
    document.body.classList.add('dropping');
  };
  const out = (event: DragEvent) => {
    // the event fires for each element that the pointer leaves; without a related target it has left the window
    if (event.relatedTarget === null) document.body.classList.remove('dropping');
  };
  addEventListener('dragenter', over);
  addEventListener('dragover', over);
  addEventListener('dragleave', out);
  addEventListener('drop', (event) => {
    event.preventDefault();
    document.body.classList.remove('dropping');
    if (event.dataTransfer) void viewer.loadFiles(collectFiles(event.dataTransfer));
  });
}
