import { parseIES } from '@farol/renderer/light-profiles';
import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { packIES } from './packIES';

const whole = readFileSync(
  new URL('../../../renderer/src/light-profiles/testing/lm63-1991-quadrants.ies', import.meta.url),
  'latin1',
);
const bytesOf = (text: string): ArrayBuffer => Uint8Array.from(text, (each) => each.charCodeAt(0)).buffer;
const textOf = (bytes: ArrayBuffer): string => Buffer.from(bytes).toString('latin1');

test('the tilt of another file comes into the photometric file, every other byte as it was', async () => {
  const [before, after] = whole.replace('Farol tests', 'Lichtk\xf6rper \x80').split(/TILT=INCLUDE\r?\n/);
  const lines = after.split(/\r?\n/);
  const text = `${before}TILT=TROUGH.TLT\n${lines.slice(4).join('\n')}`;
  const asked: string[] = [];
  const packed = await packIES(bytesOf(text), async (name) => {
    asked.push(name);
    return bytesOf(`${lines.slice(0, 4).join('\r\n')}\r\n\x1a`);
  });
  expect(asked).toEqual(['TROUGH.TLT']);
  expect(parseIES(textOf(packed)).tilt).toEqual(parseIES(whole).tilt);
  expect(textOf(packed)).toContain('Lichtk\xf6rper \x80');
  expect(textOf(packed).endsWith(lines.slice(4).join('\n'))).toBe(true);
});

test('a file that names none, or a missing one, stays as it is', async () => {
  for (const text of [whole, whole.replace('TILT=INCLUDE', 'TILT=NO.TLT'), 'no photometric file']) {
    const bytes = bytesOf(text);
    expect(await packIES(bytes, async () => null)).toBe(bytes);
  }
  expect(() => parseIES(whole.replace('TILT=INCLUDE', 'TILT=NO.TLT'))).toThrow('another file, "NO.TLT"; give that one');
});
