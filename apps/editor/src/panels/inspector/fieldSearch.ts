import { Signal } from '@farol/editing';
import type { EditorApi } from '../../api/EditorApi';

/** Text by which an editor's inspector searches its fields; '' shows all. */
export class FieldSearch {
  readonly changed = new Signal();
  private words = '';

  get text(): string {
    return this.words;
  }

  set text(text: string) {
    this.words = text;
    this.changed.emit();
  }
}

const searches = new WeakMap<EditorApi, FieldSearch>();

/** The field search of an editor, created at the first call. */
export function fieldSearchOf(editor: EditorApi): FieldSearch {
  let search = searches.get(editor);
  if (!search) searches.set(editor, (search = new FieldSearch()));
  return search;
}
