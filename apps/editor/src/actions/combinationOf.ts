import { latinKey } from '@farol/editing';
import { isPadPress, type KeyPress } from './matchKey';

const MODIFIERS = ['Control', 'Shift', 'Alt', 'Meta', 'AltGraph', 'CapsLock', 'Dead', 'Unidentified'];

/** The key combination of a press, in the form that `matchKey` takes; null while only modifiers are held. */
export function combinationOf(press: KeyPress): string | null {
  // on AZERTY, KeyM types '?', and the combination is the sign, not the letter
  let key = press.shiftKey && /^[!-~]$/.test(press.key) ? press.key : latinKey(press);
  if (MODIFIERS.includes(key)) return null;
  if (key === ' ') key = 'Space';
  // with Alt some systems type another character: the letter at the key's position is used
  if (press.altKey && /^Key[A-Z]$/.test(press.code)) key = press.code.slice(3);
  if (isPadPress(press)) key = press.code;
  const isSign = /^[^a-z0-9]$/i.test(key);
  if (key.length === 1) key = key.toUpperCase();
  const modifiers = [
    press.ctrlKey || press.metaKey ? 'Ctrl' : '',
    press.altKey ? 'Alt' : '',
    press.shiftKey && !isSign ? 'Shift' : '',
  ];
  return [...modifiers.filter(Boolean), key].join('+');
}
