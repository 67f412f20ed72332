import { type FieldValue, sameValue } from '@farol/editing/fields';
import { changeClass, fits } from '../core/changeClass';
import type { Component } from '../core/Component';
import type { ComponentClass } from '../core/ComponentClass';
import { unknownClass } from '../core/UnknownComponent';

type Values = Readonly<Record<string, FieldValue>>;

/** Values of a component before and after it was replaced by one of another class. */
interface Past {
  /** Values in the earlier class; `next` has those given in the next class, `kept` the `Memory.kept` of that time. */
  readonly left: Values;
  readonly next: Values;
  readonly kept: ReadonlyMap<string, FieldValue>;
}

interface Memory {
  /** Values that were set, also of fields that the present class does not have. */
  readonly kept: Map<string, FieldValue>;
  /** Initial values of the present class's fields. */
  initialValues: Values;
  /** For each class that the component has had, by the class's origin (its script text): its values at the end. */
  readonly pasts: Map<object | null, Past>;
}

/**
 * Carries field values of components from class to class: values that do not fit a class are kept for later classes, so
 * that undoing an edit of a script restores them.
 */
export class KeptValues {
  private readonly memories = new WeakMap<Component, Memory>();

  /**
   * Replaces a component by one of another class, or by stored data (null). Where the next class is one that it had
   * before, and its values have not been changed since, it gets back its values in that class.
   *
   * @param from - origin of the present class, equal for equal script texts; null for stored data
   * @param origin - origin of the next class
   */
  change(component: Component, type: ComponentClass | null, from: object | null, origin: object | null): void {
    const memory = this.note(component);
    const { componentClass: before } = component;
    const left = component.authoredValues();
    const past = memory.pasts.get(origin);
    const back = past !== undefined && sameValues(past.next, left) ? past : null;
    const keptNow = new Map(memory.kept);
    const data = back?.left ?? component.changedValues();
    const next = type ?? unknownClass({ type: before.typeName, version: before.version, values: data });
    const values = back || !type ? new Map(Object.entries(data)) : memory.kept;
    const after = changeClass(component, next, valuesFor(component, next, values));
    if (back) {
      memory.kept.clear();
      for (const [name, value] of back.kept) memory.kept.set(name, value);
    }
    const given = after.authoredValues();
    memory.pasts.set(from, { left, next: given, kept: keptNow });
    memory.initialValues = given;
    this.memories.set(after, memory);
  }

  /** Records which values were set since the component got its class. */
  private note(component: Component): Memory {
    const memory: Memory = this.memories.get(component) ?? { kept: new Map(), initialValues: {}, pasts: new Map() };
    for (const [name, field] of Object.entries(component.fields)) {
      const value = component.getAuthored(name);
      const given = Object.hasOwn(memory.initialValues, name) ? memory.initialValues[name] : field.default;
      if (!sameValue(value, given)) memory.kept.set(name, value);
    }
    return memory;
  }
}

const sameValues = (a: Values, b: Values): boolean => {
  const names = Object.keys(a);
  return names.length === Object.keys(b).length && names.every((name) => name in b && sameValue(a[name], b[name]));
};

/** Kept values that fit the fields of a class, migrated by the class when of an older version. */
function valuesFor(
  component: Component,
  type: ComponentClass,
  kept: ReadonlyMap<string, FieldValue>,
): Record<string, FieldValue> {
  const { version } = component.componentClass;
  let values: Record<string, unknown> = Object.fromEntries(kept);
  if (version < type.version && type.migrate) {
    try {
      values = type.migrate({ ...values }, version);
    } catch (error) {
      console.error(
        `${type.typeName}: its migration to version ${type.version} failed; mend its static migrate.`,
        error,
      );
    }
  }
  const fitting = Object.entries(values) as [string, FieldValue][];
  return Object.fromEntries(fitting.filter(([name, value]) => fits(type, name, value, component.scene)));
}
