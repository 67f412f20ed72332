import { Signal } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';

/** Text by which an editor's inspector searches its fields; '' shows all. It ends with the scene. */
export class FieldSearch {
  readonly changed = new Signal();
  private words = '';
  private endsWithSelection = false;

  constructor({ document }: EditorApi) {
    document.opened.subscribe(() => (this.text = ''));
    for (const { changed } of [document.selection, document.assetSelection])
      changed.subscribe(() => this.endsWithSelection && (this.text = ''));
  }

  get text(): string {
    return this.words;
  }

  set text(text: string) {
    this.words = text;
    this.endsWithSelection = false;
    this.changed.emit();
  }

  /** Shows one field of what is selected: the search ends with the selection, as another has no such field. */
  find(text: string): void {
    this.text = text;
    this.endsWithSelection = true;
  }
}

const searches = new WeakMap<EditorApi, FieldSearch>();

/** The field search of an editor, created at the first call. */
export function fieldSearchOf(editor: EditorApi): FieldSearch {
  let search = searches.get(editor);
  if (!search) searches.set(editor, (search = new FieldSearch(editor)));
  return search;
}
