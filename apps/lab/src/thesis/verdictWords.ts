import type { Conclusion } from './conclusions';

/** A conclusion in one line: verdict, claim, figures. */
export function verdictWords({ verdict, claim, evidence }: Conclusion): string {
  return `${verdict}: “${claim}” ${evidence}`;
}
