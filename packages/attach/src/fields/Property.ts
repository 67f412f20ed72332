import type { Field, FieldValue } from '@farol/engine/fields';

/** A value of something of three's, declared as a field of the editor is: kind, unit, range and a line of help. */
export interface Property<Target = unknown> {
  readonly name: string;
  readonly label: string;
  readonly field: Field;
  get(target: Target): FieldValue;
  set(target: Target, value: FieldValue): void;
}

/** A property with what it belongs to: one thing, or several that are edited together. */
export interface BoundProperty {
  readonly name: string;
  readonly label: string;
  readonly field: Field;
  /** The value of each of them; at least one. */
  get(): FieldValue[];
  /** @param values one for each of them */
  set(values: readonly FieldValue[]): void;
}

/** Binds properties to their targets, of which there is one at least. */
export function bind<Target>(targets: readonly Target[], properties: readonly Property<Target>[]): BoundProperty[] {
  return properties.map(({ name, label, field, get, set }) => ({
    ...{ name, label, field },
    get: () => targets.map((target) => get(target)),
    set: (values) => targets.forEach((target, i) => set(target, values[i])),
  }));
}
