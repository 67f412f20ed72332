import type { EditorApi } from '../api/EditorApi';
import { ThumbnailMaker } from './ThumbnailMaker';

const makers = new WeakMap<EditorApi, ThumbnailMaker>();

/** The thumbnail maker of an editor, created at the first call. */
export function thumbnailsOf(editor: EditorApi): ThumbnailMaker {
  let maker = makers.get(editor);
  if (!maker) makers.set(editor, (maker = new ThumbnailMaker(editor.viewport)));
  return maker;
}
