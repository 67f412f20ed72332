import type { Field, FieldValue } from '../fields/Field';
import type { FileComponent, FileObject } from '../files/FarolFile';
import { componentKey } from './instances';
import type { Prefab } from './Prefab';

const indices = new WeakMap<Prefab, ReadonlyMap<string, FileObject>>();

/** The objects of a prefab by id. */
export function objectsOf(prefab: Prefab): ReadonlyMap<string, FileObject> {
  let index = indices.get(prefab);
  if (!index) indices.set(prefab, (index = new Map(prefab.objects.map((object) => [object.id, object]))));
  return index;
}

/** The components of an object by key. The Transform is there even where the data leave it out. */
export function componentsOf(object: FileObject): Map<string, FileComponent> {
  const found = new Map(object.components.map((component) => [componentKey(object.id, component.id), component]));
  if (![...found.values()].some(({ type }) => type === 'Transform')) {
    found.set('Transform', { type: 'Transform', version: 1, id: `${object.id}:Transform`, values: {} });
  }
  return found;
}

/** The value of a field in data that leave defaults out, references as ids of an instance. */
export function valueIn(
  component: FileComponent,
  name: string,
  field: Field,
  ids: ReadonlyMap<string, string>,
): FieldValue {
  const value = Object.hasOwn(component.values, name) ? component.values[name] : field.default;
  return field.kind === 'object' && typeof value === 'string' ? (ids.get(value) ?? null) : value;
}
