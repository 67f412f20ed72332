/** What of a KeyboardEvent tells which keys are held. */
export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

/**
 * Whether a press is a combination such as 'Ctrl+Shift+Z', 'F2' or '?'. Ctrl stands for Command too. Letters go by what
 * the layout says; with Alt held, which types other signs on some systems, by the place of the key.
 */
export function matchKey(combination: string, press: KeyPress): boolean {
  const parts = combination.split('+');
  const name = parts.pop()!;
  const key = name === 'Space' ? ' ' : name;
  const isSign = /^[^a-z0-9 ]$/i.test(key);
  if (parts.includes('Ctrl') !== (press.ctrlKey || press.metaKey)) return false;
  if (parts.includes('Alt') !== press.altKey) return false;
  // a sign such as '?' says itself whether it needs Shift
  if (!isSign && parts.includes('Shift') !== press.shiftKey) return false;
  if (press.key.toLowerCase() === key.toLowerCase()) return true;
  return press.altKey && press.code === `Key${key.toUpperCase()}`;
}
