/** File names reserved for devices on Windows. */
const devices = /^(con|prn|aux|nul|com\d|lpt\d)$/i;

/** Longest name (characters); systems allow 255 bytes. */
const LONGEST = 60;

/** A name that is valid on every system, without extension: letters, marks, digits, blanks, '_' and '-'. */
export function fileNameOf(name: string): string {
  const allowed = name.normalize('NFC').replaceAll(/[^\p{L}\p{M}\p{N} _-]+/gu, '');
  const short = [...allowed.trim()].slice(0, LONGEST).join('').trim();
  return short === '' ? 'Scene' : devices.test(short) ? `${short} scene` : short;
}
