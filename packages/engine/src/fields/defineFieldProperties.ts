import type { FieldTable, FieldValue } from '@farol/editing/fields';
import type { FieldOwner } from './FieldOwner';

/**
 * Gives a class of FieldOwner one property for each field, which reads `get` and writes `set`.
 * @throws Error when a field would hide a member of the class
 */
export function defineFieldProperties(prototype: FieldOwner, fields: FieldTable): void {
  for (const name of Object.keys(fields)) {
    if (name in prototype) throw new Error(`The field '${name}' has the name of a property: give it another name.`);
    Object.defineProperty(prototype, name, {
      configurable: true,
      enumerable: true,
      get(this: FieldOwner) {
        return this.get(name);
      },
      set(this: FieldOwner, value: FieldValue) {
        this.set(name, value);
      },
    });
  }
}
