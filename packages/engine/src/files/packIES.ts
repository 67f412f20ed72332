/** Decodes bytes as text, one character per byte; non-ASCII bytes are kept. */
function textOf(bytes: Uint8Array): string {
  let text = '';
  for (let at = 0; at < bytes.length; at += 0x2000) text += String.fromCharCode(...bytes.subarray(at, at + 0x2000));
  return text;
}

/**
 * Embeds the tilt file that a photometric file names (TILT=file) into it, unchanged otherwise.
 * @param bytes - the .ies
 * @param find - returns the bytes of the tilt file; null when missing
 * @returns the same bytes when it names none or the tilt file is missing: reading the result reports that
 * @see ANSI/IES LM-63-19: TILT=INCLUDE
 */
export async function packIES(
  bytes: ArrayBuffer,
  find: (name: string) => Promise<ArrayBuffer | null>,
): Promise<ArrayBuffer> {
  const { tiltFileOf } = await import('@farol/renderer/light-profiles');
  const text = textOf(new Uint8Array(bytes));
  const name = tiltFileOf(text);
  const tilt = name === null ? null : await find(name);
  if (tilt === null) return bytes;
  // cuts off the end of the text, which is the byte 0x1A in DOS files
  const numbers = textOf(new Uint8Array(tilt)).replace(/[\0-\x20]+$/, '');
  const packed = text.replace(/^[ \t]*TILT[ \t]*=.*$/im, () => `TILT=INCLUDE\r\n${numbers}`);
  return Uint8Array.from(packed, (character) => character.charCodeAt(0)).buffer;
}
