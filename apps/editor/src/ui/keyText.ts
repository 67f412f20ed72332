import { t } from '@farol/editing';

const isMac = /Mac|iPhone|iPad/.test(navigator.platform);

/** Display text of a combination such as 'Ctrl+Shift+Z', as keyboards label it in the user's language. */
export function keyText(combination: string): string {
  combination = combination.replace('NumpadDecimal', 'Num .').replace('Numpad', 'Num ');
  combination = combination.replace('Backspace', t('Backspace')).replace('Space', t('Space'));
  if (isMac)
    return combination.replace('Ctrl+', '⌘').replace('Shift+', '⇧').replace('Alt+', '⌥').replace('Delete', '⌫');
  return combination
    .replace('Shift+', `${t('Shift')}+`)
    .replace('Delete', t('Del'))
    .replace('Escape', 'Esc');
}
