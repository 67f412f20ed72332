/** Parts of a KeyboardEvent, or of React's event around one, that tell whether an input method handles the key. */
export interface ComposedKey {
  readonly isComposing?: boolean;
  readonly keyCode?: number;
  readonly nativeEvent?: { readonly isComposing?: boolean };
}

/**
 * Whether a key belongs to an input method, which writes Chinese, Japanese or Korean: its Enter accepts a word, its
 * Escape cancels one; text fields must ignore both. Safari marks that Enter by keyCode 229 alone.
 *
 * @see https://www.w3.org/TR/uievents/#events-composition-key-events
 */
export function isComposing({ isComposing: own, keyCode, nativeEvent }: ComposedKey): boolean {
  return (own ?? nativeEvent?.isComposing ?? false) || keyCode === 229;
}
