/**
 * Key of a press for hot keys: `KeyboardEvent.key`; if that is neither a Latin letter nor a digit, the letter (lower
 * case) or digit of a US keyboard at this position: 'ы' of KeyS is 's', '&' of Digit1 (AZERTY) is '1'. Other signs and
 * names such as 'Enter' are not changed.
 */
export function latinKey({ key, code }: { readonly key: string; readonly code: string }): string {
  if (/^[a-z\d]$/i.test(key)) return key;
  return /^(?:Key([A-Z])|Digit(\d))$/.exec(code)?.slice(1).join('').toLowerCase() ?? key;
}
