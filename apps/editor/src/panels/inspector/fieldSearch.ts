import { Signal } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';

/** Search text of an editor's inspector; '' shows all fields. Cleared when another scene is opened. */
export class FieldSearch {
  readonly changed = new Signal();
  private words = '';
  private endsWithSelection = false;

  constructor({ document }: EditorApi) {
    document.opened.subscribe(() => this.find(''));
    for (const { changed } of [document.selection, document.assetSelection])
      changed.subscribe(() => this.endsWithSelection && this.find(''));
  }

  get text(): string {
    return this.words;
  }

  /** Sets the text. @param endsWithSelection - whether a new selection, which may lack the field, clears the text */
  find(text: string, endsWithSelection = false): void {
    this.words = text;
    this.endsWithSelection = endsWithSelection;
    this.changed.emit();
  }
}

const searches = new WeakMap<EditorApi, FieldSearch>();

/** The field search of an editor, created at the first call. */
export function fieldSearchOf(editor: EditorApi): FieldSearch {
  let search = searches.get(editor);
  if (!search) searches.set(editor, (search = new FieldSearch(editor)));
  return search;
}
