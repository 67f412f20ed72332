/** 'Delete chest', or 'Delete 3 objects'. @param objects at least one; one without a name goes by its type */
export function countLabel(
  verb: string,
  objects: readonly { readonly name: string; readonly type?: string }[],
): string {
  const [{ name, type = 'object' }] = objects;
  return `${verb} ${objects.length === 1 ? name || type : `${objects.length} objects`}`;
}

/** The label of a step within a sentence: 'Undo ' and 'delete chest'. */
export const lowerFirst = (label: string): string => label.charAt(0).toLowerCase() + label.slice(1);
