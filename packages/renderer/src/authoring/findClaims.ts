/** A line `//? left == right` of a microshader, which a test evaluates on the GPU. */
export interface Claim {
  /** Line in the microshader's text, from 1. */
  readonly line: number;
  /** Text of the claim as written, without `//?`. */
  readonly text: string;
  /** Statements before the comparison, each with its semicolon; '' for none. */
  readonly setup: string;
  readonly left: string;
  readonly right: string;
}

/**
 * Finds the claims in a microshader's text: `//? expression == expression`, optionally with statements before
 * (`//? float a = f(1.0); a * a == 2.0`). Floats must agree up to rounding, integers and booleans exactly.
 * @throws Error for a `//?` without a comparison
 */
export function findClaims(text: string): Claim[] {
  return text.split(/\r\n?|\n/).flatMap((raw, i) => {
    const claim = /^[ \t]*\/\/\?[ \t]*(.*?)[ \t]*$/.exec(raw)?.[1];
    if (claim === undefined) return [];
    const parts = /^((?:.*;)?)\s*(.+?)\s*==\s*(.+)$/.exec(claim);
    if (parts === null)
      throw new Error(`Line ${i + 1}: the claim "${claim}" is no equation; write "expression == expression".`);
    return { line: i + 1, text: claim, setup: parts[1], left: parts[2], right: parts[3] };
  });
}
