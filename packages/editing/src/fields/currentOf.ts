/** Newest replacement of each owner that was replaced, in a record that all of a line share. */
const lines = new WeakMap<object, { newest: object }>();

/**
 * The object that stands in an owner's place: itself, or the newest that replaced it, such as a component whose script was
 * edited. A component's id is no such reference: once free, it goes to the next component of that type.
 */
export const currentOf = <Owner extends object>(owner: Owner): Owner => (lines.get(owner)?.newest ?? owner) as Owner;

/** Records that an owner replaces another: `currentOf` then returns it, for all that the other one replaced too. */
export function replaceOwner(before: object, owner: object): void {
  const line = lines.get(before) ?? { newest: before };
  line.newest = owner;
  lines.set(before, line).set(owner, line);
}
