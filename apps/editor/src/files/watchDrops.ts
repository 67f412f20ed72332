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

/** Whether a drag event is handled here, in its current phase. */
function isOurs(event: DragEvent): event is DragEvent & { readonly dataTransfer: DataTransfer } {
  const { dataTransfer } = event;
  if (event.defaultPrevented || !dataTransfer || !(isFileDrag(dataTransfer) || isAssetDrag(dataTransfer))) return false;
  // over the hierarchy's tree the event is captured, so that the tree's own drag and drop does not see it
  return (targetOf(event).kind === 'tree') === (event.eventPhase === Event.CAPTURING_PHASE);
}

/**
 * Handles drops of files and of assets on the page: into the viewport, below an object of the tree, or elsewhere, where
 * files are only imported. Fields handle drops on themselves.
 */
export function watchDrops(editor: EditorApi): void {
  /** While a dialog is open, file drops are ignored, and the browser is kept from navigating to the file. */
  const isRefused = (event: DragEvent): boolean => {
    if (!editor.dialogs.current || !event.dataTransfer || !isFileDrag(event.dataTransfer)) return false;
    // the welcome page accepts files itself
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
    // otherwise the browser would navigate to the file
    event.preventDefault();
    const target = targetOf(event);
    if (target.kind === 'tree') event.stopPropagation();
    const asset = draggedAsset(event.dataTransfer);
    // dropped data can only be read during the event
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
