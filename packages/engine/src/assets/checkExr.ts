import { checkPixels } from './imageSize';

const HEADER = 8;
const MULTI_PART = 0x1000;

/**
 * Goes through the attributes of an EXR's header: three's loader would search for the end of one that is cut short without
 * end, and take memory for whatever size it says.
 * @throws Error when the header is not whole, or the picture or its tiles are of absurd size
 * @see OpenEXR file layout: attributes of name, type, size and value, an empty name at the end
 */
export function checkExr(bytes: ArrayBuffer): void {
  const all = new Uint8Array(bytes);
  const view = new DataView(bytes);
  let at = HEADER;
  const cut = (): never => {
    throw new Error('its header is not whole');
  };
  const readText = (): string => {
    const end = all.indexOf(0, at);
    if (end < 0) cut();
    const text = String.fromCharCode(...all.subarray(at, Math.min(end, at + 32)));
    at = end + 1;
    return text;
  };
  if (bytes.byteLength < HEADER + 1) cut();
  const isMultiPart = (view.getUint32(4, true) & MULTI_PART) !== 0;
  for (;;) {
    const name = readText();
    if (name === '') {
      // each part of several ends with an empty name, and the last one with another
      if (!isMultiPart || all[at] === 0) return;
      continue;
    }
    readText();
    if (at + 4 > all.length) cut();
    const size = view.getInt32(at, true);
    if (size < 0 || at + 4 + size > all.length) cut();
    at += 4;
    if (name === 'dataWindow' && size >= 16) {
      const [left, top, right, bottom] = [0, 4, 8, 12].map((offset) => view.getInt32(at + offset, true));
      checkPixels(right - left + 1, bottom - top + 1);
    }
    if (name === 'tiles' && size >= 8) checkPixels(view.getUint32(at, true), view.getUint32(at + 4, true));
    at += size;
  }
}
