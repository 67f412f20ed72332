/** An error for a name that is not in a list, with the list. */
export function unknownName(kind: string, name: unknown, known: readonly string[]): Error {
  return new Error(`Farol: unknown ${kind} "${String(name)}"; use one of: ${known.join(', ')}.`);
}
