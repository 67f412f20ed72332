import { changeClass, fits } from '../core/changeClass';
import type { Component, ComponentClass } from '../core/SceneGraph';
import { unknownClass } from '../core/UnknownComponent';
import type { FieldValue } from '../fields/Field';
import { sameValue } from '../fields/FieldOwner';

interface Memory {
  /** Values that were set, also of fields that the present class does not have. */
  readonly kept: Map<string, FieldValue>;
  /** What each field of the present class had at first. */
  given: ReadonlyMap<string, FieldValue>;
}

/**
 * Brings components from class to class with the values of their fields: those that do not fit a class are kept for one that
 * they fit, so that undoing the edit of a script gives back what there was.
 */
export class KeptValues {
  private readonly memories = new WeakMap<Component, Memory>();

  /** Makes a component one of another class; data that are kept when there is none. */
  change(component: Component, type: ComponentClass | null): void {
    const { kept } = this.note(component);
    const { componentClass: before } = component;
    const next = type ?? unknownClass({ type: before.typeName, version: before.version, values: changedOf(component) });
    changeClass(
      component,
      next,
      valuesFor(component, next, type ? kept : new Map(Object.entries(changedOf(component)))),
    );
    this.memories.set(component, { kept, given: new Map(Object.entries(component.authoredValues())) });
  }

  /** Notes which values were set since the component got its class. */
  private note(component: Component): Memory {
    const memory = this.memories.get(component) ?? { kept: new Map(), given: new Map() };
    for (const [name, field] of Object.entries(component.fields)) {
      const value = component.getAuthored(name);
      const given = memory.given.has(name) ? memory.given.get(name)! : field.default;
      if (!sameValue(value, given)) memory.kept.set(name, value);
    }
    return memory;
  }
}

/** Authored values that are not the default, as in a file. */
function changedOf(component: Component): Record<string, FieldValue> {
  const values: Record<string, FieldValue> = {};
  for (const [name, field] of Object.entries(component.fields)) {
    const value = component.getAuthored(name);
    if (!sameValue(value, field.default)) values[name] = value;
  }
  return values;
}

/** What the fields of a class get of kept values, by its migration where they are of an older version. */
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
      console.error(`${type.typeName}: its migration to version ${type.version} failed.`, error);
    }
  }
  const fitting = Object.entries(values) as [string, FieldValue][];
  return Object.fromEntries(fitting.filter(([name, value]) => fits(type, name, value, component.scene)));
}
