import { expect, test } from 'vitest';
import { makeLookupTable } from '../picture/chain/makeLookupTable';
import { readCube } from './readCube';

const read = (text: string) => readCube(new TextEncoder().encode(text).buffer);
const head = 'TITLE "warm"\n# a comment\nLUT_3D_SIZE 2\nDOMAIN_MIN 0 0 0\nDOMAIN_MAX 1 1 1\n\n';
const eight = ['0 0 0', '1 0 0', '0 1 0', '1 1 0', '0 0 1', '1 0 1', '0 1 1', '1 1 1'];

test('a .cube file is the table that grading takes, red first', () => {
  const texture = read(head + eight.join('\r\n'));
  const { data } = makeLookupTable(texture)!.image as { data: Uint8Array };
  expect([...data].filter((_, i) => i % 4 < 3)).toEqual(eight.flatMap((line) => line.split(' ').map((x) => +x * 255)));
});

test.each([
  ['LUT_1D_SIZE 16', /a 1D table/],
  ['LUT_3D_SIZE 1000', /whole number from 2 to 128/],
  [head + eight.slice(1).join('\n'), /has 7 colours where LUT_3D_SIZE 2 needs 8/],
  [head + [...eight, '1 1 1'].join('\n'), /more colours/],
  [head + [...eight.slice(1), '0 -- 0'].join('\n'), /colour 8 is not three numbers/],
  [head.replace('MAX 1', 'MAX 4') + eight.join('\n'), /from 0 to 1/],
  ['', /has 0 colours/],
])('what is none is refused: %#', (text, message) => expect(() => read(text)).toThrow(message));
