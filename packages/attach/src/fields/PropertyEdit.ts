import { checkFieldValue, type FieldValue, sameValue } from '@farol/engine/fields';
import type { Session } from '../model/Session';
import type { BoundProperty } from './Property';

/** A value in which a component that is null is left as each has it. */
export type PartialValue = FieldValue | readonly (number | null)[];

/** A value with what it leaves open taken from another one. */
function complete(value: PartialValue, own: FieldValue): FieldValue {
  if (!Array.isArray(value) || !Array.isArray(own)) return value as FieldValue;
  return value.map((each: number | null, i) => each ?? (own[i] as number)) as unknown as FieldValue;
}

/**
 * One edit of a property, of all that it belongs to: any number of previews, then one step of history. Nothing is kept when
 * the values are what they were before.
 */
export class PropertyEdit {
  private readonly before: readonly FieldValue[];

  constructor(
    private readonly session: Session,
    private readonly property: BoundProperty,
  ) {
    this.before = property.get();
  }

  /** Null when the value may be set, else what is wrong. */
  problemWith(value: PartialValue): string | null {
    for (const own of this.before) {
      const problem = checkFieldValue(this.property.field, complete(value, own));
      if (problem !== null) return problem;
    }
    return null;
  }

  preview(value: PartialValue): void {
    this.property.set(this.before.map((own) => complete(value, own)));
    this.session.edited.emit();
  }

  commit(): void {
    const { property, before, session } = this;
    const after = property.get();
    if (before.every((value, i) => sameValue(value, after[i]))) return;
    session.history.keep({
      label: `change of ${property.label.toLowerCase()}`,
      undo: () => property.set(before),
      redo: () => property.set(after),
    });
  }

  discard(): void {
    this.property.set(this.before);
    this.session.edited.emit();
  }
}
