const ALPHABET = '0123456789abcdefghijklmnopqrstuvwxyz';

/** A random id of 12 letters and digits (62 bits). */
export function createId(): string {
  const bytes = crypto.getRandomValues(new Uint8Array(12));
  let id = '';
  for (const byte of bytes) id += ALPHABET[byte % ALPHABET.length];
  return id;
}
