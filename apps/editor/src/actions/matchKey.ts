import { latinKey } from '@farol/editing';

/** What of a KeyboardEvent tells which keys are held. */
export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

const isPadName = (name: string): boolean => /^Numpad(\d|Decimal)$/.test(name);

/** Whether a press is of a digit or the dot of the number pad; what moves the caret, while NumLock is off, is not. */
export const isPadPress = ({ key, code }: KeyPress): boolean => key.length === 1 && isPadName(code);

/**
 * Whether a press is a combination such as 'Ctrl+Shift+Z', 'F2' or '?'. Ctrl stands for Command too. Letters and digits go
 * by what the layout says; by the place of the key where that is neither (Cyrillic, Greek, digits of AZERTY), and with Alt
 * held, which types other signs on some systems. 'Numpad1' and the like are keys of the number pad by their place, and '1'
 * is none of them.
 * @param isTyped - whether only what the layout says counts, not the place
 */
export function matchKey(combination: string, press: KeyPress, isTyped = false): boolean {
  const parts = combination.split('+');
  const name = parts.pop()!;
  const key = name === 'Space' ? ' ' : name;
  if (isPadPress(press) !== isPadName(name)) return false;
  const isSign = /^[^a-z0-9 ]$/i.test(key);
  if (parts.includes('Ctrl') !== (press.ctrlKey || press.metaKey)) return false;
  if (parts.includes('Alt') !== press.altKey) return false;
  // a sign such as '?' says itself whether it needs Shift
  if (!isSign && parts.includes('Shift') !== press.shiftKey) return false;
  if (isPadName(name)) return press.code === name;
  if (press.key.toLowerCase() === key.toLowerCase()) return true;
  if (isTyped) return false;
  if (latinKey(press).toLowerCase() === key.toLowerCase()) return true;
  return press.altKey && press.code === `Key${key.toUpperCase()}`;
}
