const isMac = /Mac|iPhone|iPad/.test(navigator.platform);

/** A combination such as 'Ctrl+Shift+Z' as the keyboard has it written. */
export function keyText(combination: string): string {
  combination = combination.replace('NumpadDecimal', 'Num .').replace('Numpad', 'Num ');
  if (!isMac) return combination.replace('Delete', 'Del').replace('Escape', 'Esc');
  return combination.replace('Ctrl+', '⌘').replace('Shift+', '⇧').replace('Alt+', '⌥').replace('Delete', '⌫');
}
