import type { Field, ValueOf } from '@farol/engine/fields';

/** What an editor of one kind of field gets. */
export interface FieldEditorProps<F extends Field> {
  readonly field: F;
  /** The field's name, such as 'normalMap'. */
  readonly name: string;
  /** Null where several objects are edited and their values differ. */
  readonly value: ValueOf<F> | null;
  /** Of a vector whose values differ: the coordinates that all have in common, null for the others. */
  readonly parts?: readonly (number | null)[];
  /** Whether the values differ. */
  readonly mixed: boolean;
  /** The texts that there are to choose from, of a field that says so; absent where any goes. */
  readonly choices?: readonly string[];
  /** Accessible name. */
  readonly label: string;
  /** Help, unit and range in words. */
  readonly description: string;
  readonly disabled: boolean;
  /** Shows a value; a function gets each object's own value. */
  onPreview(update: ValueOf<F> | ((before: ValueOf<F>) => ValueOf<F>)): void;
  /** Keeps what was shown last, or this, as one step of history. */
  onCommit(update?: ValueOf<F> | ((before: ValueOf<F>) => ValueOf<F>)): void;
  /** A value of the edit that was committed last, which comes late: part of the same step of history. */
  onAmend(update: ValueOf<F> | ((before: ValueOf<F>) => ValueOf<F>)): void;
  /** Goes back to what it was. */
  onDiscard(): void;
}
