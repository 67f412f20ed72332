/**
 * The key of a press as hot keys name it: `KeyboardEvent.key`, or, where that is neither a Latin letter nor a digit, the
 * letter or digit that a US keyboard has in its place, in small: 'ы' of KeyS is 's', '&' of Digit1 (AZERTY) is '1'. Signs
 * of other keys, and names such as 'Enter', stay as they are.
 */
export function latinKey({ key, code }: { readonly key: string; readonly code: string }): string {
  if (/^[a-z\d]$/i.test(key)) return key;
  return /^(?:Key([A-Z])|Digit(\d))$/.exec(code)?.slice(1).join('').toLowerCase() ?? key;
}
