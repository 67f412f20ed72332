import type { FieldValue } from '@farol/editing/fields';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import type { FileObject } from '../files/FarolFile';
import { componentKey } from './instances';

/** References to objects among field values, by a map of ids; what is not in it becomes null. */
export function mapReferences(
  values: Readonly<Record<string, FieldValue>>,
  type: string,
  registry: ComponentRegistry,
  ids: ReadonlyMap<string, string>,
): Record<string, FieldValue> {
  const mapped: Record<string, FieldValue> = { ...values };
  for (const [name, field] of Object.entries(registry.fieldsOf(type))) {
    const value = mapped[name];
    if (field.kind === 'object' && typeof value === 'string') mapped[name] = ids.get(value) ?? null;
  }
  // of data that are kept it is not known which are references
  if (!registry.types.has(type)) {
    for (const [name, value] of Object.entries(mapped)) {
      if (typeof value === 'string') mapped[name] = ids.get(value) ?? value;
    }
  }
  return mapped;
}

/** Objects of a file under other ids. @param ids - the new id of every one of them; a parent that is not in it becomes null */
export function copyObjects(
  objects: readonly FileObject[],
  registry: ComponentRegistry,
  ids: ReadonlyMap<string, string>,
): FileObject[] {
  return objects.map((object) => {
    const id = ids.get(object.id)!;
    return {
      ...object,
      id,
      parent: object.parent === null ? null : (ids.get(object.parent) ?? null),
      components: object.components.map((component) => ({
        ...component,
        id: `${id}:${componentKey(object.id, component.id)}`,
        values: mapReferences(component.values, component.type, registry, ids),
      })),
    };
  });
}
