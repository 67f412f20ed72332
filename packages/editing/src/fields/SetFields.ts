import type { Command } from '../history/Command';
import { currentOf } from './currentOf';
import type { FieldValue } from './Field';
import type { FieldTarget } from './FieldTarget';
import { sameValue } from './sameValue';

/** A new value for one field of a component, of a scene's settings or of an object. */
export interface FieldEdit<Owner extends FieldTarget = FieldTarget> {
  readonly owner: Owner;
  readonly name: string;
  readonly value: FieldValue;
}

const authored = <Owner extends FieldTarget>({ owner, name }: FieldEdit<Owner>): FieldEdit<Owner> => ({
  owner,
  name,
  value: currentOf(owner).getAuthored(name),
});

/**
 * Edit that undoes another one. For a view (a field that edits a part of another), it restores the whole stored field,
 * even to a value that `set` would not allow.
 */
const undoing = <Owner extends FieldTarget>({ owner, name }: FieldEdit<Owner>): FieldEdit<Owner> =>
  authored({ owner, name: currentOf(owner).fields[name]?.viewOf ?? name, value: null });

const set = ({ owner, name, value }: FieldEdit): void => currentOf(owner).set(name, value);

/** Sets all fields, or none when one value is refused. @param before - values before the call, in the same order */
function setAll(edits: readonly FieldEdit[], before: readonly FieldEdit[]): void {
  let count = 0;
  try {
    for (; count < edits.length; count++) set(edits[count]);
  } catch (error) {
    while (count-- > 0) set(before[count]);
    throw error;
  }
}

/** Command that sets authored values of fields of one or several owners; simulated values are not changed. */
export class SetFields<Owner extends FieldTarget = FieldTarget> implements Command<never> {
  /** Values before the first `do`; null until then. */
  private previousEdits: readonly FieldEdit<Owner>[] | null = null;
  /** Edits that `undo` makes, in the order of `edits`. */
  private undoes: readonly FieldEdit<Owner>[] = [];

  /** @param edits - each field of each owner at most once */
  constructor(
    readonly label: string,
    readonly edits: readonly FieldEdit<Owner>[],
  ) {}

  get isEmpty(): boolean {
    const before = this.previousEdits ?? this.edits.map(authored);
    return this.edits.every(({ value }, i) => sameValue(value, before[i].value));
  }

  /** @throws Error of the owner that refuses its value; nothing has changed then */
  do(): void {
    const before = this.previousEdits ?? this.edits.map(authored);
    if (!this.previousEdits) this.undoes = this.edits.map(undoing);
    setAll(this.edits, this.undoes);
    this.previousEdits = before;
  }

  undo(): void {
    // in reverse order, since one field's value may decide which other fields exist
    setAll(this.undoes.toReversed(), this.edits.toReversed());
  }

  replaceWith(next: Command<unknown>): SetFields<Owner> | null {
    if (!(next instanceof SetFields) || next.edits.length !== this.edits.length) return null;
    const sameFields = this.edits.every(
      ({ owner, name }, i) => currentOf(owner) === currentOf(next.edits[i].owner) && name === next.edits[i].name,
    );
    if (!sameFields) return null;
    setAll(next.edits, this.edits);
    next.previousEdits = this.previousEdits;
    next.undoes = this.undoes;
    return next;
  }
}
