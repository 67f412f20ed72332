/** Picture format by the first bytes of a file; null for other files. */
export function signatureOf(bytes: ArrayBuffer): string | null {
  const head = [...new Uint8Array(bytes, 0, Math.min(16, bytes.byteLength))];
  const text = String.fromCharCode(...head);
  if (text.startsWith('\x89PNG')) return 'PNG';
  if (text.startsWith('\xff\xd8\xff')) return 'JPEG';
  if (text.startsWith('RIFF') && text.slice(8, 12) === 'WEBP') return 'WebP';
  if (text.startsWith('#?')) return 'HDR';
  if (text.startsWith('v/1\x01')) return 'EXR';
  if (text.startsWith('\xabKTX 20\xbb')) return 'KTX2';
  return null;
}

/**
 * Checks that a file's content does not contradict its name.
 * @param wanted - format by the file's name, which is not one that `signatureOf` recognises
 * @throws Error when the file is empty, or a picture
 */
export function checkSignature(bytes: ArrayBuffer, wanted: string): void {
  if (bytes.byteLength === 0) throw new Error('the file is empty: choose it again.');
  const said = signatureOf(bytes);
  if (said !== null) throw new Error(`its bytes are ${said}, not ${wanted}: was another file renamed?`);
}
