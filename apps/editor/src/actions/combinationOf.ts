import { latinKey } from '@farol/editing';
import { isPadPress, type KeyPress } from './matchKey';

const MODIFIERS = ['Control', 'Shift', 'Alt', 'Meta', 'AltGraph', 'CapsLock', 'Dead', 'Unidentified'];

/** The combination that `matchKey` takes for a press; null while only keys such as Shift are held. */
export function combinationOf(press: KeyPress): string | null {
  // '?' of AZERTY is on KeyM, and stays a sign
  let key = press.shiftKey && /^[!-~]$/.test(press.key) ? press.key : latinKey(press);
  if (MODIFIERS.includes(key)) return null;
  if (key === ' ') key = 'Space';
  // with Alt held some systems type another sign: what is on the key counts
  if (press.altKey && /^Key[A-Z]$/.test(press.code)) key = press.code.slice(3);
  if (isPadPress(press)) key = press.code;
  const isSign = /^[^a-z0-9]$/i.test(key);
  if (key.length === 1) key = key.toUpperCase();
  const held = [
    press.ctrlKey || press.metaKey ? 'Ctrl' : '',
    press.altKey ? 'Alt' : '',
    press.shiftKey && !isSign ? 'Shift' : '',
  ];
  return [...held.filter(Boolean), key].join('+');
}
