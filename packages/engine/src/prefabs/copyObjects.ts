import type { FieldValue } from '@farol/editing/fields';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import type { FileObject } from '../files/FarolFile';
import { componentKey } from './instances';

/** Maps object references among field values to new ids; an id missing from the map becomes null. */
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
  // fields of an unknown class are not declared, so references cannot be recognised
  if (!registry.types.has(type)) {
    for (const [name, value] of Object.entries(mapped)) {
      if (typeof value === 'string') mapped[name] = ids.get(value) ?? value;
    }
  }
  return mapped;
}

/**
 * Copies objects of a file under new ids.
 * @param ids - new id of every object; a parent missing from the map becomes null
 */
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
