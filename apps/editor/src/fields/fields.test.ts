import { angle, asset, boolean, number, vector3 } from '@farol/engine/fields';
import { describe, expect, it } from 'vitest';
import { toDegrees } from './AngleEditor';
import { describeField } from './describeField';
import { labelOfField } from './labelOfField';
import { stepOf } from './stepOf';

describe('fields', () => {
  it('says help, range and unit, angles in degrees', () => {
    expect(describeField(number(1, { unit: 'm', min: 0, max: 5, help: 'A.' }))).toBe('A. From 0 to 5 m.');
    expect(describeField(angle(1, { min: 0, max: Math.PI / 2, help: 'B.' }))).toBe('B. From 0 to 90°.');
    expect(describeField(vector3([0, 0, 0], { unit: 'm', help: 'C.' }))).toBe('C. In m.');
    expect(describeField(number(0, { min: 1, help: 'D.' }))).toBe('D. At least 1.');
    expect(describeField(boolean(true, { help: 'E.' }))).toBe('E.');
  });

  it('makes words of a name without a label', () => {
    expect(labelOfField('shadowMapSize', number(0, { help: '' }))).toBe('Shadow map size');
    expect(labelOfField('map', asset('texture', null, { help: '', label: 'Colour map' }))).toBe('Colour map');
  });

  it('shows whole degrees as whole', () => {
    expect(toDegrees(Math.PI / 3)).toBe(60);
    expect(toDegrees((50 * Math.PI) / 180)).toBe(50);
  });

  it('goes by the declared step, else by one that suits the range', () => {
    expect(stepOf({ step: 0.25 })).toBe(0.25);
    expect(stepOf({ integer: true })).toBe(1);
    expect(stepOf({ min: 0, max: 1 })).toBeCloseTo(0.01);
    expect(stepOf({ min: 0, max: 1000 })).toBeCloseTo(10);
    expect(stepOf({ min: 0 })).toBe(0.1);
  });
});
