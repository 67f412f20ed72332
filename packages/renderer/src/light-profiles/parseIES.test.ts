import { expect, test } from 'vitest';
import { parseIES, tiltFileOf } from './parseIES';
import { PhotometricProfile } from './PhotometricProfile';

const files = import.meta.glob<string>('./testing/*.ies', { query: '?raw', import: 'default', eager: true });
const fileOf = (name: string) => files[`./testing/${name}.ies`];
const profileOf = (name: string, tilt = 0) => new PhotometricProfile(parseIES(fileOf(name)), tilt);

/** Vertical angle, horizontal angle (degrees), intensity by hand (cd). */
type Intensities = readonly (readonly [vertical: number, horizontal: number, wanted: number])[];

const S = Math.SQRT1_2;
const degrees = (radians: number) => (radians * 180) / Math.PI;

test.each<[name: string, Intensities]>([
  [
    // multiplier 2, ballast 0.9, ballast-lamp 0.5
    'lm63-1986-rotational',
    [
      [0, 0, 360],
      [22.5, 123, 270],
      [33.75, 300, 225],
      [90, 0, 0],
      [91, 0, 0],
      [180, 0, 0],
    ],
  ],
  [
    // ballast 0.5, ballast-lamp 0.8; all four quadrants as the first
    'lm63-1991-quadrants',
    [
      [0, 0, 40],
      [0, 90, 48],
      [45, 22.5, 34],
      [45, 135, 36],
      [45, 157.5, 34],
      [45, 202.5, 34],
      [45, 337.5, 34],
      [90, 270, 12],
    ],
  ],
  [
    // multiplier 10; the second factor is for future use; mirrored in the plane of 0 and 180
    'lm63-1995-halves',
    [
      [60, 0, 80],
      [60, 90, 70],
      [60, 270, 70],
      [60, 45, 75],
      [60, 315, 75],
      [60, 180, 60],
      [120, 225, 10],
      [150, 90, 0],
    ],
  ],
  [
    // mirrored in the plane of 90 and 270
    'lm63-1995-from-90',
    [
      [90, 90, 10],
      [90, 180, 20],
      [90, 0, 20],
      [90, 270, 30],
      [90, 45, 15],
      [90, 135, 15],
      [90, 315, 25],
      [45, 180, 12.5],
    ],
  ],
  [
    'lm63-2002-up',
    [
      [0, 0, 0],
      [89, 0, 0],
      [90, 0, 0],
      [112.5, 77, 35],
      [180, 0, 100],
    ],
  ],
  [
    // vertical angles turn from down (0) to across (90), both sides mirrored
    'lm63-2002-type-b',
    [
      [0, 0, 1000],
      [45, 0, 500],
      [45, 180, 100],
      [22.5, 0, 750],
      [22.5, 180, 550],
      [90, 0, 0],
      [45, 90, 500],
      [45, 270, 500],
      [30, 90, (1000 * 60) / 90],
      [120, 0, 0],
      // V 45° in the plane H 45°: down, across and side are 1/2, 1/2 and √½
      [60, degrees(Math.atan2(S, 0.5)), 250],
    ],
  ],
  [
    // aims down; horizontal angles are clockwise, those of a type C are not
    'lm63-2002-type-a',
    [
      [0, 0, 800],
      [45, 90, 500],
      [45, 270, 600],
      [45, 0, 400],
      [89.999999, 90, 200],
      [135, 90, 0],
    ],
  ],
  [
    // ballast 0.5; the second number says how the file was made
    'lm63-2019-whole',
    [
      [0, 0, 50],
      [90, 0, 5],
      [90, 90, 10],
      [90, 225, 17.5],
      [90, 315, 12.5],
      [90, 359.9999999, 5],
      [135, 90, 6.5],
      [180, 12, 3],
    ],
  ],
])('%s has the intensities that are worked out by hand', (name, intensities) => {
  const profile = profileOf(name);
  for (const [vertical, horizontal, wanted] of intensities) {
    const seen = profile.intensityAt(vertical, horizontal);
    expect(seen, `${vertical}°, ${horizontal}°`).toBeCloseTo(wanted, 4);
    expect(profile.intensityAt(vertical, horizontal - 360)).toBeCloseTo(seen, 6);
  }
});

test('lines may end as on DOS and on old Macintoshes, with marks before and after the text', () => {
  const text = fileOf('lm63-1986-rotational').trim();
  for (const end of ['\r\n', '\r']) {
    const data = parseIES(`\uFEFF${text.replaceAll('\n', end)}${end}\u001A\0`);
    expect(data).toEqual(parseIES(text));
  }
});

test('the head, the keywords and the luminous opening are read', () => {
  const heads = Object.fromEntries(
    Object.keys(files).map((path) => [path.slice('./testing/'.length, -'.ies'.length), parseIES(files[path])]),
  );
  expect(
    Object.entries(heads).map(([name, { version }]) => name.startsWith(version.toLowerCase().replace('lm-', 'lm'))),
  ).toEqual(Array.from({ length: 8 }, () => true));
  expect(heads['lm63-1986-rotational'].keywords.get('LABEL')).toBe(
    'Workshop reflector, no head and no keywords\nMade up for tests',
  );
  expect(heads['lm63-1986-rotational']).toMatchObject({
    type: 'C',
    lamps: 1,
    lumensPerLamp: 1000,
    width: 0.3048,
    length: 0.6096,
    height: 0.1524,
    inputWatts: 100,
  });
  const { keywords } = heads['lm63-1991-quadrants'];
  expect(keywords.get('LUMINAIRE')).toBe('Trough for two tubes\nwith a louvre');
  expect([...keywords.keys()]).toEqual(['TEST', 'MANUFAC', 'LUMINAIRE', 'OTHER']);
  expect(heads['lm63-2002-up'].width).toBe(-0.1);
});

test('the tilt of lamps that is in the file scales the light by the tilt that is asked for', () => {
  expect(parseIES(fileOf('lm63-1991-quadrants')).tilt).toMatchObject({ geometry: 2 });
  const at = (tilt: number) => profileOf('lm63-1991-quadrants', tilt).intensityAt(0, 0);
  expect([at(0), at(45), at(-45)]).toEqual([40, 32, 32]);
  expect(at(67.5)).toBeCloseTo(26, 9);
  expect([profileOf('lm63-1991-quadrants', 90).maximumIntensity, at(170)]).toEqual([24, 20]);
});

test('the tilt of lamps that is in another file is read from there, and what is wrong in it is told', () => {
  const whole = fileOf('lm63-1991-quadrants');
  const own = parseIES(whole);
  const [before, after] = whole.split(/TILT=INCLUDE\r?\n/);
  const numbers = after.split(/\r?\n/);
  const text = `${before}tilt = Lamps\\TROUGH.TLT \n${numbers.slice(4).join('\n')}`;
  expect(tiltFileOf(text)).toBe('Lamps\\TROUGH.TLT');
  const tilt = `\uFEFF${numbers.slice(0, 4).join('\r\n')}\r\n\x1a`;
  expect(parseIES(text, { tilt })).toEqual(own);
  expect(() => parseIES(text, { tilt: '2 3\n0 45 90\n1 x' })).toThrow(
    /^Line 7: in "Lamps\\TROUGH\.TLT", line 3: "x" is not a number; write tilt factors there\.$/,
  );
  for (const each of ['NONE', 'include', '']) expect(tiltFileOf(`IESNA91\nTILT=${each}\n1`)).toBeNull();
  expect(tiltFileOf('no photometric file')).toBeNull();
  // a text within a keyword is no tilt line
  expect(tiltFileOf(whole)).toBeNull();
});

/** Reads the texture as shaders do: texels are at their angles, linear between. */
function sampled(profile: PhotometricProfile, vertical: number, horizontal: number): number {
  const { image } = profile.texture;
  const { width, height } = image;
  const half = (bits: number) => {
    const exponent = (bits >> 10) & 31;
    return exponent === 0 ? (bits & 1023) * 2 ** -24 : (1 + (bits & 1023) / 1024) * 2 ** (exponent - 15);
  };
  const texel = (x: number, y: number) =>
    half((image.data as unknown as Uint16Array)[(y % height) * width + Math.min(x, width - 1)]);
  const x = (vertical / 180) * (width - 1);
  const y = height === 1 ? 0 : (horizontal / 360) * height;
  const [i, j] = [Math.floor(x), Math.floor(y)];
  const row = (k: number) => texel(i, k) * (1 - (x - i)) + texel(i + 1, k) * (x - i);
  return row(j) * (1 - (y - j)) + row(j + 1) * (y - j);
}

test.each(Object.keys(files))('the texture of %s has the intensities of the file, as parts of the largest', (path) => {
  const profile = new PhotometricProfile(parseIES(files[path]));
  const { data, maximumIntensity } = profile;
  // in two files light ends at an angle, and between texels, type B has arcs
  const error = data.type === 'C' ? 1e-3 : 5e-3;
  for (let v = 0; v <= 180; v += 3.75) {
    if (Math.abs(v - data.verticalAngles.at(-1)!) < 1 && v < 180) continue;
    for (let h = 0; h < 360; h += 7.5) {
      const wanted = profile.intensityAt(v, h) / maximumIntensity;
      expect(Math.abs(sampled(profile, v, h) - wanted), `${v}°, ${h}°`).toBeLessThan(error);
    }
  }
  expect(profile.texture).toBe(profile.texture);
});

test('textures are no larger than the angles of the file need', () => {
  const sizeOf = (name: string) => {
    const { width, height } = profileOf(name).texture.image;
    return [width, height];
  };
  expect(sizeOf('lm63-1986-rotational')).toEqual([9, 1]);
  // lit at its last angle, 90°: half a degree, so that nothing shines up
  expect(sizeOf('lm63-1991-quadrants')).toEqual([361, 8]);
  expect(sizeOf('lm63-2019-whole')).toEqual([3, 4]);
  expect(sizeOf('lm63-2002-type-b')).toEqual([361, 720]);
});

test('the luminous flux is the integral over all directions', () => {
  const uniform = parseIES('IESNA:LM-63-2002\nTILT=NONE\n1 -1 100 2 1 1 2 0 0 0 1 1 0\n0 180\n0\n1 1');
  expect(new PhotometricProfile(uniform).luminousFlux / (400 * Math.PI)).toBeCloseTo(1, 4);
  // cos over the lower half: π times the intensity straight down
  const angles = Array.from({ length: 91 }, (_, i) => i);
  const cosines = angles.map((a) => Math.cos((a * Math.PI) / 180).toFixed(9));
  const lambert = parseIES(
    `IESNA:LM-63-2002\nTILT=NONE\n1 -1 100 91 1 1 2 0 0 0 1 1 0\n${angles.join(' ')}\n0\n${cosines.join('\n')}`,
  );
  expect(new PhotometricProfile(lambert).luminousFlux / (100 * Math.PI)).toBeCloseTo(1, 3);
});

test('a plane at 360° that a file leaves out is that at 0', () => {
  const data = parseIES('IESNA91\nTILT=NONE\n1 -1 1 2 4 1 2 0 0 0 1 1 0\n0 180\n0 90 180 270\n1 1 2 2 3 3 4 4');
  const profile = new PhotometricProfile(data);
  expect([270, 315, 345].map((h) => profile.intensityAt(90, h))).toEqual([4, 2.5, 1.5]);
});

const HEAD = 'IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n';
test.each([
  ['', 'Line 1: there is no line that begins with TILT=; choose a photometric file in the LM-63 format (.ies).'],
  ['<!doctype html>\n<p>Not found', 'Line 1: there is no line that begins with TILT='],
  [
    'IESNA91\nTILT=LAMP.TLT\n',
    'Line 2: the tilt of lamps is in another file, "LAMP.TLT"; give that one too, or write TILT=INCLUDE and its numbers after this line, or TILT=NONE.',
  ],
  ['IESNA91\nTILT=INCLUDE\n4\n', 'Line 3: the lamp-to-luminaire geometry is 4; write a whole number from 1 to 3.'],
  [`${HEAD}1 1000 x`, 'Line 4: "x" is not a number; write the candela multiplier there.'],
  [`${HEAD}1 1000 1 0x10 1`, 'Line 4: "0x10" is not a number; write the number of vertical angles there.'],
  [`${HEAD}1 1000 1\n1.5 1`, 'Line 5: the number of vertical angles is 1.5; write a whole number from 2 to 3601.'],
  [`${HEAD}1 1000 1\n3601 3601 1`, 'Line 5: 3601 × 3601 candela values are too many; use fewer angles.'],
  [`${HEAD}1 1000 1 2 1 7`, 'Line 4: the photometric type is 7; write a whole number from 1 to 3.'],
  [
    `${HEAD}1 1000 1 3 1 1 2 0 0 0 1 1 0\n0 90\n45`,
    'Line 6: vertical angles go from 90 to 45; put them in ascending order.',
  ],
  [
    `${HEAD}1 1000 1 2 1 1 2 0 0 0 1 1 0\n-90 90\n0`,
    'Line 5: vertical angles of type C go from -90 to 90; keep them within 0 to 180.',
  ],
  [
    `${HEAD}1 1000 1 2 2 1 2 0 0 0 1 1 0\n0 90\n0 120\n1 2 3 4`,
    'Line 6: horizontal angles of type C go from 0 to 120; they may end at 0, 90, 180 or 360, or go from 90 to 270.',
  ],
  [
    `${HEAD}1 1000 1 2 2 2 2 0 0 0 1 1 0\n0 90\n0 120\n1 2 3 4`,
    'Line 6: horizontal angles of type B go from 0 to 120; they may go from -90 to 90, or from 0 to 90.',
  ],
  [
    `${HEAD}1 1000 1 2 1 1 2 0 0 0 1 1 0\n0 90\n0\n1\n`,
    'Line 7: the file ends before candelas; get a complete copy of the file.',
  ],
])('a broken file is told by its line and what to do about it: %j', (text, message) => {
  expect(() => parseIES(text)).toThrow(message);
});

test('a file of long lines is read, and told by its line', () => {
  const head = (blanks: number) => `IESNA:LM-63-2002\n[TEST] a${' '.repeat(blanks)}b\nTILT=NONE\n`;
  // a pattern with backtracking would take minutes, and exceed the test runner's limit
  expect(() => parseIES(`${head(1_000_000)}1 ${'1'.repeat(300_000)}x`)).toThrow(/Line 4: "1+" is not a number/);
  const whole = fileOf('lm63-1986-rotational').replace(/^/, 'IESNA:LM-63-2002\n[TEST]   two  words \t\n');
  expect(parseIES(whole).keywords.get('TEST')).toBe('two  words');
});
