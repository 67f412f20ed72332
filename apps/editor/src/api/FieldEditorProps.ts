import type { Field, FieldOwner, ValueOf } from '@farol/engine/fields';

/** Properties of the editor of one kind of field. */
export interface FieldEditorProps<F extends Field> {
  readonly field: F;
  /** Name of the field, such as 'normalMap'. */
  readonly name: string;
  /** Null when several objects are edited and their values differ. */
  readonly value: ValueOf<F> | null;
  /**
   * Coordinates of a vector that are equal in all edited objects, null for others; absent when no coordinates differ.
   */
  readonly parts?: readonly (number | null)[];
  /** Whether the field's values differ between the selected owners. */
  readonly mixed: boolean;
  /** Allowed texts of a text field with choices; absent when any text is allowed. */
  readonly choices?: readonly string[];
  /** Accessible name of the control. */
  readonly label: string;
  /** Help text of the field with its unit and range. */
  readonly description: string;
  readonly disabled: boolean;
  /** Previews a value; a function computes it from each object's own. */
  onPreview(update: ValueOf<F> | ((before: ValueOf<F>) => ValueOf<F>)): void;
  /** Commits the last preview, or the given value, as one step of history. */
  onCommit(update?: ValueOf<F> | ((before: ValueOf<F>) => ValueOf<F>)): void;
  /** Merges a value that arrives after the commit into the same step of history. */
  onAmend(update: ValueOf<F> | ((before: ValueOf<F>) => ValueOf<F>)): void;
  /** Called to discard the preview, as by Escape. */
  onDiscard(): void;
}

/** Properties of an editor that reads other fields of the owners too. */
export interface OwnerFieldProps<F extends Field> extends FieldEditorProps<F> {
  /** Edited components, of one type; memoised. */
  readonly owners: readonly FieldOwner[];
}
