import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { parseIES } from './parseIES';
import { PhotometricProfile } from './PhotometricProfile';
import { writeIES } from './writeIES';

const folder = join(import.meta.dirname, 'testing');

test.each(readdirSync(folder).filter((file) => file.endsWith('.ies')))(
  '%s is the same when written and read',
  (file) => {
    const profile = new PhotometricProfile(parseIES(readFileSync(join(folder, file), 'latin1')));
    const again = new PhotometricProfile(parseIES(writeIES(profile)));
    const { version: _, tilt: __, keywords, ...numbers } = profile.data;
    expect(again.data).toMatchObject(numbers);
    expect(again.maximumIntensity).toBe(profile.maximumIntensity);
    if (!keywords.has('LABEL')) expect(again.data.keywords).toEqual(keywords);
  },
);

test('the tilt of lamps is in the candelas, and names in other letters can be written', () => {
  const text = `IESNA:LM-63-2002\n[MANUFAC] ランプ é\nTILT=INCLUDE\n1\n2\n0 90\n0.5 1\n1 900 1 2 1 1 2 0 0 0\n1 1 20\n0 90\n0\n8 2\n`;
  const written = writeIES(new PhotometricProfile(parseIES(text)));
  expect(parseIES(written)).toMatchObject({ tilt: null, candelas: Float64Array.of(4, 1) });
  expect(written).toContain('[MANUFAC] ??? é');
  expect(written.split('\r\n').every((line) => line.length <= 256)).toBe(true);
});
