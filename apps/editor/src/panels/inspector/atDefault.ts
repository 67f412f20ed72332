import { type FieldOwner, sameValue } from '@farol/engine/fields';

/** Whether a field has its default. */
export const isAtDefault = (owner: FieldOwner, name: string): boolean =>
  sameValue(owner.getAuthored(name), owner.fields[name].default);

/** Whether all of some fields have their defaults. Names of fields that the owner lacks are ignored. */
export const allAtDefault = (owner: FieldOwner, names: readonly string[]): boolean =>
  names.every((name) => !Object.hasOwn(owner.fields, name) || isAtDefault(owner, name));
