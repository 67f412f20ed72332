import type { Editor } from '../Editor';
import { collectFiles } from './collectFiles';
import { draggedAsset, isAssetDrag, isFileDrag } from './dragAsset';
import type { DropTarget } from './dropOn';

function targetOf(event: DragEvent): DropTarget {
  const element = event.target instanceof Element ? event.target : null;
  if (element?.closest('.viewport-place')) return { kind: 'picture', x: event.clientX, y: event.clientY };
  if (element?.closest('.hierarchy')) {
    const row = element.closest<HTMLElement>('[data-object-id]');
    return { kind: 'tree', id: row?.dataset.objectId ?? null };
  }
  return { kind: 'elsewhere' };
}

/**
 * Takes what is dropped on the page, files from outside and assets of the editor's: into the picture, below an object of
 * the tree, or elsewhere, where files are imported only. What a field takes for itself is not heard of here.
 */
export function watchDrops(editor: Editor): void {
  window.addEventListener('dragover', (event) => {
    const { dataTransfer } = event;
    if (event.defaultPrevented || !dataTransfer || !(isFileDrag(dataTransfer) || isAssetDrag(dataTransfer))) return;
    if (isAssetDrag(dataTransfer) && targetOf(event).kind === 'elsewhere') return;
    event.preventDefault();
    dataTransfer.dropEffect = 'copy';
  });
  window.addEventListener('drop', (event) => {
    const { dataTransfer } = event;
    if (event.defaultPrevented || !dataTransfer || !(isFileDrag(dataTransfer) || isAssetDrag(dataTransfer))) return;
    // else the browser would leave the editor for the file
    event.preventDefault();
    const asset = draggedAsset(dataTransfer);
    // what is dropped can be read during the event only
    const files = asset ? new Map<string, File>() : collectFiles(dataTransfer);
    const target = targetOf(event);
    editor.attempt(async () => {
      const { dropOn } = await import('./dropOn');
      await dropOn(editor, { asset, files: await files }, target);
    });
  });
}
