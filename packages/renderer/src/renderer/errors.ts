import { nearestName } from '../microshaders/nearestName';

/** Error for an unknown name: it lists the known names, and the nearest of them. */
export function unknownName(kind: string, name: unknown, known: readonly string[]): Error {
  const near = nearestName(String(name), known);
  return new Error(
    `Farol: unknown ${kind} "${String(name)}"; use one of: ${known.join(', ')}.${near ? ` Is "${near}" meant?` : ''}`,
  );
}
