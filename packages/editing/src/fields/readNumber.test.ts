import { describe, expect, it } from 'vitest';
import { readNumber, readNumberInRange } from './readNumber';

const valueOf = (text: string, unit?: string, before = 0): number | string => {
  const read = readNumber(text, unit);
  return read.problem ?? read.valueFor(before);
};

describe('what is typed as a number', () => {
  it.each([
    ['1e-3', 0.001],
    ['1/3', 0.333333333333333],
    ['2*3+1', 7],
    ['2+3*4', 14],
    ['1,5', 1.5],
    [',5', 0.5],
    ['0,125', 0.125],
    ['1.', 1],
    ['pi/2', 1.5707963267949],
    ['2π', 6.28318530717959],
    ['sqrt(2)', Math.SQRT2],
    ['3(1+1)', 6],
    ['2 sqrt(4)', 4],
    ['-2^2', -4],
    ['2^-1', 0.5],
    ['2**3', 8],
    ['- -5', 5],
    ['8/2/2', 2],
    ['1 - 2 - 3', -4],
    ['0.1+0.2', 0.3],
    ['0.1234567890123456', 0.1234567890123456],
    ['  7 ', 7],
    ['−4', -4],
    ['2×3÷4', 1.5],
    ['50%', 0.5],
    ['sin(90°)', 1],
    ['cos(pi)', -1],
    ['ROUND(2.6)', 3],
    ['1E3', 1000],
    ['1000,5', 1000.5],
  ])('%s is %d', (text, value) => {
    expect(valueOf(text)).toBeCloseTo(value, 12);
  });

  // international yard and pound agreement of 1959; SI prefixes; CSS
  it.each([
    ['m', { m: 1, km: 1000, cm: 0.01, mm: 0.001, µm: 1e-6, um: 1e-6, nm: 1e-9 }],
    ['m', { in: 0.0254, '"': 0.0254, ft: 0.3048, "'": 0.3048, yd: 0.9144, mi: 1609.344 }],
    ['rad', { rad: 1, mrad: 0.001, deg: Math.PI / 180, '°': Math.PI / 180, turn: 2 * Math.PI, turns: 2 * Math.PI }],
    ['s', { s: 1, ms: 0.001, µs: 1e-6, us: 1e-6, min: 60, h: 3600 }],
    ['W', { W: 1, kW: 1000, mW: 0.001 }],
    ['cd', { cd: 1, kcd: 1000 }],
    ['lm', { lm: 1, klm: 1000 }],
    ['lx', { lx: 1, klx: 1000 }],
    ['Hz', { Hz: 1, kHz: 1000 }],
  ])('in a field of %s: each unit by its own size %o', (field, units) => {
    for (const [unit, size] of Object.entries(units))
      expect(valueOf(`3 ${unit}`, field), unit).toBeCloseTo(3 * size, 12);
  });

  it('keeps the digits of a number as it was typed, and no others', () => {
    expect(valueOf('0.30000000000000004')).toBe(0.30000000000000004);
    expect(valueOf('0.1+0.2')).toBe(0.3);
    expect(valueOf('3*1cm', 'm')).toBe(0.03);
  });

  it.each([
    ['30cm', 'm', 0.3],
    ['1/3 m', 'm', 1 / 3],
    ['1/2cm', 'm', 0.005],
    ['10 m/4', 'm', 2.5],
    ['2 m + 30cm', 'm', 2.3],
    ['1 + 30cm', 'm', 1.3],
    ['5ft 3in', 'm', 1.6002],
    ['5\'3"', 'm', 1.6002],
    ['(1+2) mm', 'm', 0.003],
    ['90deg', '°', 90],
    ['90 °', '°', 90],
    ['2 rad', '°', 114.591559026165],
    ['pi/2 rad', '°', 90],
    ['1/4 turn', '°', 90],
    ['atan(1)', '°', 45],
    ['500ms', 's', 0.5],
    ['1min 30s', 's', 90],
    ['36 km/h', 'm/s', 10],
    ['10 m/2 s', 'm/s', 5],
    ['2 kHz', 'Hz', 2000],
    ['1/20ms', 'Hz', 50],
    ['1/3 m', '1/m', 1 / 3],
    ['2 m', '1/m', 'The unit does not fit: this number is in 1/m.'],
    ['4/cm²', '1/m²', 40000],
    ['1 kcd', 'cd or lx', 1000],
    ['20 lx', 'cd or lx', 20],
    ['3 nt', 'cd or lx or nt', 3],
    ['2 kcd/m²', 'cd or lx or nt', 2000],
    ['512 texels', 'texels', 512],
    ['5 CM', 'm', 0.05],
  ])('%s in %s is %s', (text, unit, value) => {
    if (typeof value === 'string') expect(valueOf(text, unit)).toBe(value);
    else expect(valueOf(text, unit)).toBeCloseTo(value, 10);
  });

  it.each([
    ['+=0.5', 2.5],
    ['-=0.5', 1.5],
    ['*=2', 4],
    ['/=4', 0.5],
    ['+= 1/4', 2.25],
    ['+=30cm', 2.3],
    ['*=50%', 1],
    ['+=-1', 1],
  ])('%s goes by the value before', (text, value) => {
    const read = readNumber(text, 'm');
    expect(read.problem).toBeNull();
    expect(read).toHaveProperty('isRelative', true);
    expect(valueOf(text, 'm', 2)).toBe(value);
  });

  it.each([
    ['abc', '“abc” is neither a unit nor a function.'],
    ['12q', '“q” is neither a unit nor a function.'],
    ['1 2', 'Between “1” and “2” a sign such as + is missing.'],
    ['1.2.3', '“1.2.3” has two decimal points.'],
    ['1,234', '“1,234” may be 1234 or 1.234: write one of them.'],
    ['1,234.5', '“1,234.5” has two decimal points.'],
    ['1/0', 'A number cannot be divided by 0.'],
    ['sqrt(-1)', 'There is no such number.'],
    ['9^999', 'This is larger than a number can be.'],
    ['3$', '“$” has no place in a number.'],
    ['2)', 'There is one “)” too many.'],
    ['*2', 'A number cannot begin with “*”.'],
    ['2*/3', 'Between “*” and “/” a number is missing.'],
    ['m', 'Before “m” a number is missing.'],
    ['1kg', '“kg” is neither a unit nor a function.'],
    ['1s', 'The unit does not fit: this number is in m.'],
    ['1m + 1s', 'What is added has to be in units of one kind.'],
    ['*=2m', 'A factor has no unit: leave the unit out.'],
    ['/=0', 'A number cannot be divided by 0.'],
    ['+=10%', 'To change a number by a part of it, write *= and a factor, such as *=1.1.'],
    ['('.repeat(80), 'There are too many brackets.'],
    ['-'.repeat(90), 'There are too many brackets.'],
    ['1'.repeat(201), 'This is too long for a number.'],
    ['constructor', '“constructor” is neither a unit nor a function.'],
    ['toString(1)', '“toString” is neither a unit nor a function.'],
    ['__proto__', '“_” has no place in a number.'],
  ])('%s is refused, and it is said why', (text, problem) => {
    expect(valueOf(text, 'm')).toBe(problem);
  });

  it('takes no unit where there is none', () => {
    expect(valueOf('30cm')).toBe('This number has no unit: leave the unit out.');
  });

  it.each(['', '1/', '2*(', '+=', '-', '1e', '1e-', 'sqrt', 'sqrt(', '(1+2', 'sq'])(
    '%s may become a number',
    (text) => {
      expect(readNumber(text)).toHaveProperty('isIncomplete', true);
    },
  );

  it('refuses what is beyond the range, and changes each value as far as the range goes', () => {
    const range = { unit: 'm', min: 0, max: 2 };
    expect(readNumberInRange('3', range).problem).toBe('It must be from 0 to 2 m.');
    expect(readNumberInRange('-1', { min: 0 }).problem).toBe('It must be at least 0.');
    expect(readNumberInRange('91', { unit: '°', max: 90 }).problem).toBe('It must be at most 90°.');
    expect(readNumberInRange('150cm', range)).toHaveProperty('problem', null);
    const more = readNumberInRange('+=50cm', range);
    expect(more.problem === null && [0.1, 1, 1.9].map((before) => more.valueFor(before))).toEqual([0.6, 1.5, 2]);
  });

  it('takes any text without throwing, and gives finite numbers alone', () => {
    let state = 12345;
    const random = (): number => (state = (Math.imul(state, 1103515245) + 12345) >>> 0) / 2 ** 32;
    const parts = ['1', '0', '2.5', ',', '.', 'e', '-', '+', '*', '/', '^', '(', ')', ' ', 'pi', 'cm', 'm', 's', '%'];
    parts.push('sqrt', 'ln(', '°', '=', '+=', '/=', '1e308', '²', '∞', '\0', '\ud800', '😀', '__proto__', 'NaN', 'min');
    const units = [undefined, 'm', '°', 'm/s', '1/m²', 'cd or lx', '%', '×', 'Hz', 'texels', 'rad/px'];
    let read = 0;
    for (let i = 0; i < 50_000; i++) {
      const length = 1 + Math.floor(random() * 8);
      const text = Array.from({ length }, () => parts[Math.floor(random() * parts.length)]).join('');
      const result = readNumber(text, units[Math.floor(random() * units.length)]);
      if (result.problem !== null) {
        if (result.problem.length <= 5) expect.fail(`${JSON.stringify(text)}: ${result.problem}`);
        continue;
      }
      read++;
      if (![0, -3.5, 1e300].every((before) => Number.isFinite(result.valueFor(before)))) expect.fail(text);
    }
    expect(read).toBeGreaterThan(1000);
  });
});
