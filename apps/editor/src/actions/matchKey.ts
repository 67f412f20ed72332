import { latinKey } from '@farol/editing';

/** The properties of a KeyboardEvent that are used. */
export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

const isPadName = (name: string): boolean => /^Numpad(\d|Decimal)$/.test(name);

/** Whether a press is a digit or the dot of the number pad; cursor keys of the pad (NumLock off) are not. */
export const isPadPress = ({ key, code }: KeyPress): boolean => key.length === 1 && isPadName(code);

/**
 * Whether a press matches a combination such as 'Ctrl+Shift+Z', 'F2' or '?'. Ctrl also stands for Command. Letters and
 * digits are compared by the typed character; by the key's position when it types neither (Cyrillic, Greek, AZERTY
 * digits), or with Alt, which types other characters on some systems. 'Numpad1' and the like are keys of the number
 * pad, '1' does not match them.
 * @param isTyped - whether only the typed character counts, not the position
 */
export function matchKey(combination: string, press: KeyPress, isTyped = false): boolean {
  const parts = combination.split('+');
  const name = parts.pop()!;
  const key = name === 'Space' ? ' ' : name;
  if (isPadPress(press) !== isPadName(name)) return false;
  const isSign = /^[^a-z0-9 ]$/i.test(key);
  if (parts.includes('Ctrl') !== (press.ctrlKey || press.metaKey)) return false;
  if (parts.includes('Alt') !== press.altKey) return false;
  // a sign such as '?' implies whether Shift is needed
  if (!isSign && parts.includes('Shift') !== press.shiftKey) return false;
  if (isPadName(name)) return press.code === name;
  if (press.key.toLowerCase() === key.toLowerCase()) return true;
  if (isTyped) return false;
  if (latinKey(press).toLowerCase() === key.toLowerCase()) return true;
  return press.altKey && press.code === `Key${key.toUpperCase()}`;
}
