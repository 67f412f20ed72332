import type { FieldValue } from './Field';

/** What a kind of field allows that the engine does not know by itself. */
export interface FieldType {
  /** Of `custom` fields. */
  readonly name: string;
  /** What it allows, as the end of "must be …". */
  readonly allows: string;
  /** Whether it allows a value. NaN and infinities are no values in any case. */
  check(value: FieldValue): boolean;
}

const types = new Map<string, FieldType>();

/** Makes a type known for `custom` fields. The same one may come again. @throws Error when another has the name */
export function registerFieldType(type: FieldType): void {
  const known = types.get(type.name);
  if (known && known !== type)
    throw new Error(`There is a type of fields '${type.name}' already: choose another name.`);
  types.set(type.name, type);
}

/** The type of this name; undefined when none was registered. */
export const fieldTypeOf = (name: string): FieldType | undefined => types.get(name);
