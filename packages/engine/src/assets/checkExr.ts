const HEADER = 8;
const MULTI_PART = 0x1000;

/**
 * Goes through the attributes of an EXR's header: three's loader would search for the end of one that is cut short without
 * end.
 * @throws Error when the header is not whole
 * @see OpenEXR file layout: attributes of name, type, size and value, an empty name at the end
 */
export function checkExr(bytes: ArrayBuffer): void {
  const all = new Uint8Array(bytes);
  const view = new DataView(bytes);
  let at = HEADER;
  const cut = (): never => {
    throw new Error('its header is not whole');
  };
  const skipText = (): number => {
    const end = all.indexOf(0, at);
    if (end < 0) cut();
    const length = end - at;
    at = end + 1;
    return length;
  };
  if (bytes.byteLength < HEADER + 1) cut();
  const isMultiPart = (view.getUint32(4, true) & MULTI_PART) !== 0;
  for (;;) {
    if (skipText() === 0) {
      // each part of several ends with an empty name, and the last one with another
      if (!isMultiPart || all[at] === 0) return;
      continue;
    }
    skipText();
    if (at + 4 > all.length) cut();
    const size = view.getInt32(at, true);
    if (size < 0 || at + 4 + size > all.length) cut();
    at += 4 + size;
  }
}
