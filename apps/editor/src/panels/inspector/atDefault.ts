import { type FieldOwner, sameValue } from '@farol/engine/fields';

/** Whether a field has its default value. */
export const isAtDefault = (owner: FieldOwner, name: string): boolean =>
  sameValue(owner.getAuthored(name), owner.fields[name].default);

/** Whether all of these fields have their default values. Names of fields that the owner lacks are ignored. */
export const allAtDefault = (owner: FieldOwner, names: readonly string[]): boolean =>
  names.every((name) => !Object.hasOwn(owner.fields, name) || isAtDefault(owner, name));
