import type { EditorApi } from '../api/EditorApi';
import { collectFiles } from '@farol/engine/files';
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

/** Whether an event is a drag that the editor takes at this point of its way. */
function isOurs(event: DragEvent): event is DragEvent & { readonly dataTransfer: DataTransfer } {
  const { dataTransfer } = event;
  if (event.defaultPrevented || !dataTransfer || !(isFileDrag(dataTransfer) || isAssetDrag(dataTransfer))) return false;
  // the tree has drags of its own, and would take these for such: it does not get to hear of them
  return (targetOf(event).kind === 'tree') === (event.eventPhase === Event.CAPTURING_PHASE);
}

/**
 * Takes what is dropped on the page, files from outside and assets of the editor's: into the picture, below an object of
 * the tree, or elsewhere, where files are imported only. What a field takes for itself is not heard of here.
 */
export function watchDrops(editor: EditorApi): void {
  /** An open dialog is answered first: nothing is taken behind it, and the browser does not leave the editor for the file. */
  const isRefused = (event: DragEvent): boolean => {
    if (!editor.dialogs.current || !event.dataTransfer || !isFileDrag(event.dataTransfer)) return false;
    // the welcome takes files itself
    if (event.target instanceof Element && event.target.closest('.welcome')) return false;
    event.preventDefault();
    event.stopPropagation();
    event.dataTransfer.dropEffect = 'none';
    return true;
  };
  const over = (event: DragEvent): void => {
    if (isRefused(event)) return;
    if (!isOurs(event)) return;
    const { kind } = targetOf(event);
    if (kind === 'elsewhere' && isAssetDrag(event.dataTransfer)) return;
    event.preventDefault();
    if (kind === 'tree') event.stopPropagation();
    event.dataTransfer.dropEffect = 'copy';
  };
  const drop = (event: DragEvent): void => {
    if (isRefused(event) || !isOurs(event)) return;
    // else the browser would leave the editor for the file
    event.preventDefault();
    const target = targetOf(event);
    if (target.kind === 'tree') event.stopPropagation();
    const asset = draggedAsset(event.dataTransfer);
    // what is dropped can be read during the event only
    const files = asset ? new Map<string, File>() : collectFiles(event.dataTransfer);
    editor.attempt(async () => {
      const { dropOn } = await import('./dropOn');
      await dropOn(editor, { asset, files: await files }, target);
    });
  };
  for (const isCapture of [true, false]) {
    window.addEventListener('dragover', over, isCapture);
    window.addEventListener('drop', drop, isCapture);
  }
}
