import { Signal } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';

/** Text by which an editor's inspector searches its fields; '' shows all. It ends with the scene. */
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

  /** @param endsWithSelection - for a field of what is selected, which another selection lacks */
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
