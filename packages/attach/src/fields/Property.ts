import type { Field, FieldValue } from '@farol/engine';
import { sameValue } from '@farol/engine';
import type { Session } from '../model/Session';

/** A value of something of three's, declared as a field of the editor is: kind, unit, range and a line of help. */
export interface Property<Target = unknown> {
  readonly name: string;
  readonly label: string;
  readonly field: Field;
  get(target: Target): FieldValue;
  set(target: Target, value: FieldValue): void;
}

/** A property with what it belongs to. */
export interface BoundProperty {
  readonly name: string;
  readonly label: string;
  readonly field: Field;
  get(): FieldValue;
  set(value: FieldValue): void;
}

/** Binds properties to their target. */
export function bind<Target>(target: Target, properties: readonly Property<Target>[]): BoundProperty[] {
  return properties.map(({ name, label, field, get, set }) => ({
    ...{ name, label, field },
    get: () => get(target),
    set: (value) => set(target, value),
  }));
}

/**
 * One edit of a property: any number of previews, then one step of history. Nothing is kept when the value is what it was
 * before.
 */
export class PropertyEdit {
  private readonly before: FieldValue;

  constructor(
    private readonly session: Session,
    private readonly property: BoundProperty,
  ) {
    this.before = property.get();
  }

  preview(value: FieldValue): void {
    this.property.set(value);
    this.session.edited.emit();
  }

  commit(): void {
    const { property, before, session } = this;
    const after = property.get();
    if (sameValue(before, after)) return;
    session.history.keep({
      label: `change of ${property.label.toLowerCase()}`,
      undo: () => property.set(before),
      redo: () => property.set(after),
    });
  }

  discard(): void {
    this.preview(this.before);
  }
}
