import { nearestName } from '../microshaders/nearestName';

/** An error for a name that is not in a list, with the list and the name of it that may have been meant. */
export function unknownName(kind: string, name: unknown, known: readonly string[]): Error {
  const near = nearestName(String(name), known);
  return new Error(
    `Farol: unknown ${kind} "${String(name)}"; use one of: ${known.join(', ')}.${near ? ` Is "${near}" meant?` : ''}`,
  );
}
