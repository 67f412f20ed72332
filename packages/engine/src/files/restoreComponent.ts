import type { Component } from '../core/Component';
import type { ComponentData } from '../core/ComponentClass';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import { ProblemList } from './ProblemList';
import { readComponent } from './readComponent';

/**
 * Makes a component, on no object yet, from checked and migrated data whose class is now registered.
 * @throws FileError listing what is wrong with the data; Error for a type that the registry does not know
 */
export function restoreComponent(data: ComponentData, registry: ComponentRegistry): Component {
  const { typeName } = registry.get(data.type);
  const problems = new ProblemList();
  const read = readComponent({ ...data, id: typeName }, typeName, registry, problems);
  problems.throwIfAny();
  return registry.create(typeName, read!.values);
}
