import { IESError } from './IESError';
import { NumberReader } from './NumberReader';
import type { IESVersion, LampTilt, PhotometricData } from './PhotometricData';

const METRES_PER_FOOT = 0.3048;
const LINE_END = /\r\n?|\n/;
const TILT_LINE = /^[ \t]*TILT[ \t]*=(.*)$/im;
const TYPES = ['C', 'B', 'A'] as const;
/** Maximum number of angles of one kind; goniometers measure some hundreds. */
const MOST_ANGLES = 3601;
const MOST_CANDELAS = 1 << 22;

const HEADS: readonly (readonly [pattern: RegExp, version: IESVersion])[] = [
  [/^IESNA91\b/i, 'LM-63-1991'],
  [/^IESNA?\s*:?\s*LM-63-19?95\b/i, 'LM-63-1995'],
  [/^IESNA?\s*:?\s*LM-63-(20)?02\b/i, 'LM-63-2002'],
  [/^IES(NA)?\s*:?\s*LM-63-(20)?19\b/i, 'LM-63-2019'],
  [/^IES(NA)?\s*:?\s*LM-63/i, 'LM-63-2002'],
];

/** Options of `parseIES`. */
export interface IESOptions {
  /**
   * Text of the file named by `TILT=` (see `tiltFileOf`), with the numbers that otherwise follow `TILT=INCLUDE`. Default: no
   * such file.
   */
  readonly tilt?: string | null;
}

/**
 * Name of the file with the tilt table of a photometric file, as written after `TILT=`; null if there is none, or the table is
 * in the file itself.
 */
export function tiltFileOf(text: string): string | null {
  const value = TILT_LINE.exec(withoutMarks(text))?.[1].trim() ?? 'NONE';
  return /^(NONE|INCLUDE)?$/i.test(value) ? null : value;
}

/**
 * Reads a photometric file of the LM-63 standard, of any edition from 1986 to 2019.
 * @throws IESError for any other text, with the line and what to write there
 * @see ANSI/IES LM-63-19, Approved Method: IES Standard File Format for the Electronic Transfer of Photometric Data
 */
export function parseIES(text: string, { tilt: tiltText = null }: IESOptions = {}): PhotometricData {
  const lines = withoutMarks(text).split(LINE_END);
  const tiltLine = lines.findIndex((line) => /^\s*TILT\s*=/i.test(line));
  if (tiltLine < 0) {
    throw new IESError(
      1,
      'there is no line that begins with TILT=; choose a photometric file in the LM-63 format (.ies).',
    );
  }
  const version = versionOf(lines[0]);
  const reader = new NumberReader(lines, tiltLine + 1);
  const tilt = readTilt(lines[tiltLine], tiltLine + 1, reader, tiltText);
  const lamps = reader.number('the number of lamps');
  const lumensPerLamp = reader.number('lumens per lamp');
  const multiplier = reader.number('the candela multiplier');
  const vertical = reader.count('the number of vertical angles', 2, MOST_ANGLES);
  const horizontal = reader.count('the number of horizontal angles', 1, MOST_ANGLES);
  if (vertical * horizontal > MOST_CANDELAS) {
    throw new IESError(reader.line, `${vertical} × ${horizontal} candela values are too many; use fewer angles.`);
  }
  const type = TYPES[reader.count('the photometric type', 1, 3) - 1];
  const metres = reader.count('the unit of lengths (1 feet, 2 metres)', 1, 2) === 1 ? METRES_PER_FOOT : 1;
  const [width, length, height] = reader.numbers(3, 'width, length and height');
  const ballast = reader.number('the ballast factor');
  const second = reader.number('the ballast-lamp photometric factor');
  const inputWatts = reader.number('input watts');
  const verticalAngles = reader.ascending(vertical, 'vertical angles');
  checkVertical(verticalAngles, type, reader.line);
  const horizontalAngles = reader.ascending(horizontal, 'horizontal angles');
  checkHorizontal(horizontalAngles, type, reader.line);
  const candelas = reader.numbers(vertical * horizontal, 'candelas');
  // later editions use the second number otherwise: in LM-63-2019 for how the file was made
  const factor = multiplier * ballast * (version === 'LM-63-1986' || version === 'LM-63-1991' ? second : 1);
  for (let i = 0; i < candelas.length; i++) candelas[i] = Math.max(0, candelas[i] * factor);
  return {
    version,
    keywords: readKeywords(lines.slice(version === 'LM-63-1986' ? 0 : 1, tiltLine), version),
    type,
    lamps,
    lumensPerLamp,
    width: width * metres,
    length: length * metres,
    height: height * metres,
    inputWatts,
    tilt,
    verticalAngles,
    horizontalAngles,
    candelas,
  };
}

/** Removes the byte order mark at the start, and DOS's end-of-file mark at the end. */
function withoutMarks(text: string): string {
  let end = text.length;
  while (end > 0 && text.charCodeAt(end - 1) <= 0x20) end--;
  return text.slice(text.charCodeAt(0) === 0xfeff ? 1 : 0, end);
}

function versionOf(head: string): IESVersion {
  return HEADS.find(([pattern]) => pattern.test(head.trim()))?.[1] ?? 'LM-63-1986';
}

function readKeywords(lines: readonly string[], version: IESVersion): Map<string, string> {
  const keywords = new Map<string, string>();
  const add = (key: string, text: string) => {
    const before = keywords.get(key);
    keywords.set(key, before === undefined ? text : `${before}\n${text}`);
  };
  let last = 'LABEL';
  for (const line of lines) {
    const found = /^\s*\[([^\]]+)\]/.exec(line);
    if (found === null) {
      if (version === 'LM-63-1986' && line.trim() !== '') add('LABEL', line.trim());
      continue;
    }
    const key = found[1].trim().toUpperCase();
    if (key !== 'MORE') last = key;
    add(last, line.slice(found[0].length).trim());
  }
  return keywords;
}

/** @param line - line of the file, from 1 @param other - text of the file named by `TILT=`; null for none */
function readTilt(text: string, line: number, reader: NumberReader, other: string | null): LampTilt | null {
  const value = text.slice(text.indexOf('=') + 1).trim();
  if (/^NONE$/i.test(value)) return null;
  if (/^INCLUDE$/i.test(value)) return readLampTilt(reader);
  const name = value.slice(0, 40);
  if (other === null) {
    throw new IESError(
      line,
      `the tilt of lamps is in another file, "${name}"; give that one too, or write TILT=INCLUDE and its numbers after this line, or TILT=NONE.`,
    );
  }
  try {
    return readLampTilt(new NumberReader(withoutMarks(other).split(LINE_END), 0));
  } catch (error) {
    if (!(error instanceof IESError)) throw error;
    throw new IESError(line, `in "${name}", line ${error.line}: ${error.problem}`);
  }
}

function readLampTilt(reader: NumberReader): LampTilt {
  const geometry = reader.count('the lamp-to-luminaire geometry', 1, 3);
  const count = reader.count('the number of tilt angles', 1, MOST_ANGLES);
  return {
    geometry,
    angles: reader.ascending(count, 'tilt angles'),
    factors: reader.numbers(count, 'tilt factors'),
  };
}

function checkVertical(angles: Float64Array, type: PhotometricData['type'], line: number): void {
  const [least, most] = type === 'C' ? [0, 180] : [-90, 90];
  if (angles[0] >= least && angles[angles.length - 1] <= most) return;
  throw new IESError(
    line,
    `vertical angles of type ${type} go from ${angles[0]} to ${angles[angles.length - 1]}; keep them within ${least} to ${most}.`,
  );
}

function checkHorizontal(angles: Float64Array, type: PhotometricData['type'], line: number): void {
  const first = angles[0];
  const last = angles[angles.length - 1];
  if (type !== 'C') {
    if (first >= -90 && last <= 90 && first <= 0) return;
    throw new IESError(
      line,
      `horizontal angles of type ${type} go from ${first} to ${last}; they may go from -90 to 90, or from 0 to 90.`,
    );
  }
  if (first === 90 && last === 270) return;
  if (first === 0 && (last === 0 || last === 90 || (last >= 180 && last <= 360))) return;
  throw new IESError(
    line,
    `horizontal angles of type C go from ${first} to ${last}; they may end at 0, 90, 180 or 360, or go from 90 to 270.`,
  );
}
