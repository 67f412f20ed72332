import { describe, expect, it } from 'vitest';
import { toDegrees } from './angles';
import { describeField } from './describeField';
import { fieldInUnit } from './fieldInUnit';
import type { FieldDescription } from './FieldTarget';
import { formatNumber } from './formatNumber';
import { labelOfField } from './labelOfField';
import { numberDisplay } from './NumberDisplay';
import { roundToStep } from './roundToStep';
import { stepOf } from './stepOf';

const field = (kind: string, rest: Omit<FieldDescription, 'kind'>): FieldDescription => ({ kind, ...rest });

describe('what is said of a field', () => {
  it('says help, range and unit, angles in degrees', () => {
    expect(describeField(field('number', { unit: 'm', min: 0, max: 5, help: 'A.' }))).toBe('A. From 0 to 5 m.');
    expect(describeField(field('angle', { min: 0, max: Math.PI / 2, help: 'B.' }))).toBe('B. From 0 to 90°.');
    expect(describeField(field('vector3', { unit: 'm', help: 'C.' }))).toBe('C. In m.');
    expect(describeField(field('number', { min: 1, help: 'D.' }))).toBe('D. At least 1.');
    expect(describeField(field('number', { max: 0.123456, help: 'D.' }))).toBe('D. At most 0.1235.');
    expect(describeField(field('boolean', { help: 'E.' }))).toBe('E.');
  });

  it('makes words of a name without a label', () => {
    expect(labelOfField('shadowMapSize', {})).toBe('Shadow map size');
    expect(labelOfField('map', { label: 'Colour map' })).toBe('Colour map');
  });

  it('goes by the declared step, else by one that suits the range', () => {
    expect(stepOf({ step: 0.25 })).toBe(0.25);
    expect(stepOf({ integer: true })).toBe(1);
    expect(stepOf({ min: 0, max: 1 })).toBeCloseTo(0.01);
    expect(stepOf({ min: 0, max: 1000 })).toBeCloseTo(10);
    expect(stepOf({ min: 0 })).toBe(0.1);
  });
});

describe('a unit that goes by another field', () => {
  const intensity = field('number', {
    ...{ unit: 'cd or lx', help: '' },
    unitBy: { field: 'type', units: { point: 'cd', spot: 'cd', sun: 'lx' } },
  });
  const unitFor = (...types: string[]): string | undefined => fieldInUnit(intensity, () => types).unit;

  it('is that of the owners, and all of them where they differ', () => {
    expect([unitFor('point'), unitFor('sun'), unitFor('point', 'spot')]).toEqual(['cd', 'lx', 'cd']);
    expect([unitFor('point', 'sun'), unitFor('torch')]).toEqual(['cd or lx', 'cd or lx']);
  });

  it('makes one description for each unit, and none for a field without', () => {
    expect(fieldInUnit(intensity, () => ['point'])).toBe(fieldInUnit(intensity, () => ['spot']));
    const plain = field('number', { unit: 'm', help: '' });
    expect(fieldInUnit(plain, () => ['point'])).toBe(plain);
  });
});

describe('numbers as they are shown', () => {
  it('shows whole degrees as whole', () => {
    expect(toDegrees(Math.PI / 3)).toBe(60);
    expect(toDegrees((50 * Math.PI) / 180)).toBe(50);
  });

  it.each(['angle', 'euler'])('shows radians of kind %s in degrees, and stays within the limits', (kind) => {
    const limits = { min: -Math.PI / 3, max: 1.2345678912345 };
    const { unit, min, max, step, toShown, fromShown } = numberDisplay(field(kind, { ...limits, help: '' }));
    expect([unit, min, step]).toEqual(['°', -60, 1]);
    expect(fromShown(max!)).toBe(limits.max);
    expect(fromShown(min!)).toBe(limits.min);
    expect(fromShown(61)).toBeCloseTo(1.0646508, 6);
    expect(fromShown(90)).toBeGreaterThan(limits.max); // the caller refuses or clamps the value
    for (const degrees of [0, 1, -17.5, 45, 0.123456789]) expect(toShown(fromShown(degrees))).toBe(degrees);
  });

  it('shows numbers as they are, whole ones whole', () => {
    const { unit, step, toShown, fromShown } = numberDisplay(field('vector3', { unit: 'm', help: '' }));
    expect([unit, step, toShown(1.23456789), fromShown(1.23456789)]).toEqual(['m', 0.1, 1.23456789, 1.23456789]);
    expect(numberDisplay(field('number', { integer: true, help: '' })).fromShown(2.7)).toBe(3);
  });

  it('writes as many decimals as there is room for, and no zeros at the end', () => {
    expect([formatNumber(2, 'long'), formatNumber(0.1234567, 'long')]).toEqual(['2', '0.12346']);
    expect([formatNumber(-1.5, 'short'), formatNumber(0.1234567, 'short')]).toEqual(['-1.5', '0.123']);
    expect([-63.4345, -163.4345, 1234.56].map((value) => formatNumber(value, 'short'))).toEqual([
      ...['-63.43', '-163.4', '1234.6'],
    ]);
    expect(formatNumber(-1e-9, 'short')).toBe('0');
    expect(formatNumber(42.97183, 'long', 1)).toBe('42.97');
    expect([0.333333, 12.3456, 0.0067].map((value) => formatNumber(value, 'long', 0.1))).toEqual([
      '0.333',
      '12.35',
      '0.0067',
    ]);
    expect(formatNumber(-0.00051, 'long', 0.0001)).toBe('-0.00051');
    expect([formatNumber(1.23e-4, 'short'), formatNumber(-2e-7, 'long')]).toEqual(['0.00012', '-2e-7']);
  });

  it('adds steps without leaving digits behind, and keeps those that were typed', () => {
    expect(roundToStep(0.7 + 0.1, 0.1)).toBe(0.8);
    expect(roundToStep(-1.6 + 0.8000000000000003, 0.1)).toBe(-0.8);
    expect(roundToStep(0.12345678 + 0.1, 0.1)).toBe(0.22345678);
    expect(roundToStep(0.0003 + 0.0001, 0.0001)).toBe(0.0004);
    expect(roundToStep(30 + 10, 10)).toBe(40);
  });
});

it('numbers are shown and typed in a unit of the user’s choice, in steps as fine', () => {
  const shown = numberDisplay(field('number', { unit: 'lm', min: 0, step: 0.1, scale: 4 * Math.PI, help: '' }));
  expect([shown.unit, shown.min, shown.step]).toEqual(['lm', 0, 1]);
  expect(shown.toShown(69.232401)).toBe(870);
  expect(shown.fromShown(870)).toBeCloseTo(69.2324, 4);
});
