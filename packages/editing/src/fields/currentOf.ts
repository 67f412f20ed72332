/** Newest replacement of each replaced owner, in a record shared by all predecessors. */
const lines = new WeakMap<object, { newest: object }>();

/**
 * Current object in place of an owner: the owner itself, or the newest replacement, for instance after an edit of a
 * component's script. (A component's id would not do, as a later component of the type may reuse it.)
 */
export const currentOf = <Owner extends object>(owner: Owner): Owner => (lines.get(owner)?.newest ?? owner) as Owner;

/** Records that an owner replaces another one; `currentOf` then returns it for all earlier owners too. */
export function replaceOwner(before: object, owner: object): void {
  const line = lines.get(before) ?? { newest: before };
  line.newest = owner;
  lines.set(before, line).set(owner, line);
}
