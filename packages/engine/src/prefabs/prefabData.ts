import { checkFieldValue, type Field, type FieldValue } from '@farol/editing/fields';
import type { FileComponent, FileObject } from '../files/FarolFile';
import { viewedValue } from '../fields/storedValues';
import type { Component } from '../core/Component';
import { componentKey } from './instances';
import type { Prefab } from '../core/Prefab';

const indices = new WeakMap<Prefab, ReadonlyMap<string, FileObject>>();

export function objectsOf(prefab: Prefab): ReadonlyMap<string, FileObject> {
  let index = indices.get(prefab);
  if (!index) indices.set(prefab, (index = new Map(prefab.objects.map((object) => [object.id, object]))));
  return index;
}

/** The components of an object by key, including the Transform even if the data omit it. */
export function componentsOf(object: FileObject): Map<string, FileComponent> {
  const found = new Map(object.components.map((component) => [componentKey(object.id, component.id), component]));
  if (![...found.values()].some(({ type }) => type === 'Transform')) {
    found.set('Transform', { type: 'Transform', version: 1, id: `${object.id}:Transform`, values: {} });
  }
  return found;
}

/**
 * Value of a field in data that omit defaults; references are converted to ids of an instance. A value that the field
 * of an edited script no longer allows counts as the default; a value of an unknown class that the data do not have is
 * undefined.
 */
export function valueIn(
  component: FileComponent,
  name: string,
  field: Field,
  ids: ReadonlyMap<string, string>,
): FieldValue | undefined {
  if (field.viewOf !== undefined) return viewedValue(component.values, name, field);
  const has = Object.hasOwn(component.values, name) && checkFieldValue(field, component.values[name]) === null;
  const value = has ? component.values[name] : (field.default as FieldValue | undefined);
  return field.kind === 'object' && typeof value === 'string' ? (ids.get(value) ?? null) : value;
}

/** Fields whose value decides which views (`Field.viewOf`) a component has. */
const sourcesOfViews = ['surface', 'model', 'parts'];

/**
 * Names of the fields by which a component is compared with data: views (uniforms, morph weights) one by one if all the
 * compared components have the same views, else the fields that store them.
 */
export function comparedFields(own: Component, ...others: readonly FileComponent[]): string[] {
  const { fields } = own;
  const names = Object.keys(fields);
  const viewed = new Set(names.flatMap((name) => fields[name].viewOf ?? []));
  if (viewed.size === 0) return names;
  const isSame = sourcesOfViews.every((source) => {
    if (!Object.hasOwn(fields, source)) return true;
    const value = own.getAuthored(source);
    return others.every(({ values }) => (values[source] ?? fields[source].default) === value);
  });
  return names.filter((name) => (isSame ? !viewed.has(name) : fields[name].viewOf === undefined));
}
