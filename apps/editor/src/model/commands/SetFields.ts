import { type FieldOwner, type FieldValue, sameValue } from '@farol/engine/fields';
import type { Command } from '../Command';

/** A field of a component, or of a scene's settings, and what it shall be. */
export interface FieldEdit {
  readonly owner: FieldOwner;
  readonly name: string;
  readonly value: FieldValue;
}

const authored = ({ owner, name }: FieldEdit): FieldEdit => ({ owner, name, value: owner.getAuthored(name) });

/** Sets all, or none when one is refused. @param before - what they are now */
function setAll(edits: readonly FieldEdit[], before: readonly FieldEdit[]): void {
  let count = 0;
  try {
    for (; count < edits.length; count++) edits[count].owner.set(edits[count].name, edits[count].value);
  } catch (error) {
    while (count-- > 0) before[count].owner.set(before[count].name, before[count].value);
    throw error;
  }
}

/** Sets fields of one or of many owners: authored values, which simulation does not touch. */
export class SetFields implements Command {
  /** What the fields were before the first `do`. */
  private before: readonly FieldEdit[] | null = null;

  /** @param edits - each field of each owner at most once */
  constructor(
    readonly label: string,
    readonly edits: readonly FieldEdit[],
  ) {}

  get isEmpty(): boolean {
    const before = this.before ?? this.edits.map(authored);
    return this.edits.every(({ value }, i) => sameValue(value, before[i].value));
  }

  /** @throws FieldError naming the field and what it allows; nothing has changed then */
  do(): void {
    const before = this.before ?? this.edits.map(authored);
    setAll(this.edits, before);
    this.before = before;
  }

  undo(): void {
    setAll(this.before!, this.edits);
  }

  replaceWith(next: Command): Command | null {
    if (!(next instanceof SetFields) || next.edits.length !== this.edits.length) return null;
    const sameFields = next.edits.every(
      ({ owner, name }, i) => owner === this.edits[i].owner && name === this.edits[i].name,
    );
    if (!sameFields) return null;
    setAll(next.edits, this.edits);
    next.before = this.before;
    return next;
  }
}
