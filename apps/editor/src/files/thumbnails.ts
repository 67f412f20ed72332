import type { EditorApi } from '../api/EditorApi';
import { ThumbnailMaker } from './ThumbnailMaker';

const makers = new WeakMap<EditorApi, ThumbnailMaker>();

/** What draws the small pictures of an editor's assets. */
export function thumbnailsOf(editor: EditorApi): ThumbnailMaker {
  let maker = makers.get(editor);
  if (!maker) makers.set(editor, (maker = new ThumbnailMaker(editor.viewport)));
  return maker;
}
