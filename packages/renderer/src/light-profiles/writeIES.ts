import type { PhotometricProfile } from './PhotometricProfile';

const NUMBERS_OF_A_LINE = 8;
const TYPES = { C: 1, B: 2, A: 3 } as const;

function linesOf(numbers: ArrayLike<number>): string[] {
  const lines: string[] = [];
  for (let i = 0; i < numbers.length; i += NUMBERS_OF_A_LINE)
    lines.push(Array.prototype.slice.call(numbers, i, i + NUMBERS_OF_A_LINE).join(' '));
  return lines;
}

/**
 * Writes a profile as a photometric file: edition 2002, or 1995 if horizontal angles go from 90° to 270°, which later editions
 * lack. Candelas include the tilt of the lamps; reading the file gives the same numbers. Letters outside of Latin-1 become
 * question marks.
 * @see ANSI/IES LM-63-19
 */
export function writeIES({ data, tiltFactor }: PhotometricProfile): string {
  const { verticalAngles, horizontalAngles, candelas } = data;
  const isHalf = data.type === 'C' && horizontalAngles.length > 1 && horizontalAngles[0] === 90;
  const keywords = [...data.keywords].flatMap(([key, text]) =>
    text.split('\n').map((line, i) => `[${i > 0 ? 'MORE' : key === 'LABEL' ? 'OTHER' : key}] ${line}`),
  );
  const lines = [
    isHalf ? 'IESNA:LM-63-1995' : 'IESNA:LM-63-2002',
    ...keywords,
    'TILT=NONE',
    [
      ...[data.lamps, data.lumensPerLamp, 1, verticalAngles.length, horizontalAngles.length],
      ...[TYPES[data.type], 2, data.width, data.length, data.height],
    ].join(' '),
    `1 1 ${data.inputWatts}`,
    ...linesOf(verticalAngles),
    ...linesOf(horizontalAngles),
  ];
  for (let row = 0; row < horizontalAngles.length; row++) {
    const first = row * verticalAngles.length;
    const own = candelas.subarray(first, first + verticalAngles.length);
    lines.push(...linesOf(tiltFactor === 1 ? own : own.map((value) => value * tiltFactor)));
  }
  const text = [...`${lines.join('\r\n')}\r\n`];
  return text.map((letter) => (letter.codePointAt(0)! > 255 ? '?' : letter)).join('');
}
