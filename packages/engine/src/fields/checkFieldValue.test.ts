import {
  angle,
  asset,
  boolean,
  checkFieldValue,
  choice,
  colour,
  curve,
  custom,
  euler,
  type Field,
  type FieldType,
  gradient,
  isFieldVisible,
  number,
  object,
  string,
  vector3,
} from '@farol/editing/fields';
import { describe, expect, test } from 'vitest';
import { createRandom } from '../base/createRandom';
import { randomFieldValue } from './randomFieldValue';

const help = 'For a test.';
const even: FieldType = {
  name: 'even',
  allows: 'an even number',
  check: (value) => typeof value === 'number' && value % 2 === 0,
};
const fields: Record<Field['kind'], Field> = {
  number: number(1, { min: 0, max: 2, unit: 'm', help }),
  angle: angle(1, { min: 0, max: 3, help }),
  boolean: boolean(true, { help }),
  string: string('', { help }),
  choice: choice('a', ['a', 'b'], { help }),
  vector3: vector3([0, 0, 0], { min: -1, max: 1, help }),
  euler: euler([0, 0, 0], { help }),
  colour: colour([0, 0, 0], { help }),
  curve: curve([[0, 1]], { min: 0, max: 2, unit: 'm', help }),
  gradient: gradient([[0, [1, 1, 1], 1]], { help }),
  asset: asset('mesh', null, { help }),
  object: object(null, { help }),
  custom: custom(even, 2, { help }),
};

const wrong: Record<Field['kind'], unknown[]> = {
  number: [NaN, Infinity, -0.1, 2.1, '1', null, [1]],
  angle: [NaN, -0.1, 3.1, '1'],
  boolean: [0, 1, 'true', null],
  string: [1, null, ['']],
  choice: ['c', '', 0, null, ['a']],
  vector3: [[0, 0], [0, 0, 0, 0], [0, NaN, 0], [0, 2, 0], ['0', 0, 0], { x: 0, y: 0, z: 0 }, 1, null],
  euler: [[0, 0, Infinity], [0, 0], 0],
  colour: [[-0.1, 0, 0], [0, 0, NaN], '#ffffff', 0xffffff],
  curve: [
    ...[
      [],
      [[0, 3]],
      [[0, NaN]],
      [[NaN, 0]],
      [[-0.1, 0]],
      [
        [0, 1],
        [1.1, 1],
      ],
      [
        [0.5, 1],
        [0.4, 1],
      ],
      [[0, 1, 1]],
      [0, 1, 1],
    ],
    ...[[0, 1], [[0]], [['0', 1]], [[0, null]], 1, null, 'ease', [null], Array.from({ length: 65 }, () => [0, 1])],
  ],
  gradient: [
    ...[[], [[0, null, 1]], [[0, [1, 1, 1], null]], [[0, [1, 1], 1]], [[0, [-1, 0, 0], 1]], [[0, [1, NaN, 0], 1]]],
    ...[
      [[0, [1, 1, 1], 1.1]],
      [[0, [1, 1, 1], '1']],
      [[0, [1, 1, 1]]],
      [
        [0.5, [1, 1, 1], 1],
        [0.4, null, 1],
      ],
      [1, 1, 1],
    ],
    ...[null, '#ffffff', [[0, '#ffffff', 1]], [[1.5, [1, 1, 1], 1]]],
  ],
  asset: [1, '', undefined],
  object: [1, '', undefined],
  custom: [1, NaN, '2', undefined, { a: 2 }],
};

describe.each(Object.keys(fields) as Field['kind'][])('a field of kind %s', (kind) => {
  test('allows its default and whatever is in its range', () => {
    const random = createRandom(5);
    expect(checkFieldValue(fields[kind], fields[kind].default)).toBeNull();
    for (let i = 0; i < 50; i++)
      expect(checkFieldValue(fields[kind], randomFieldValue(fields[kind], random))).toBeNull();
  });

  test.each(wrong[kind].map((value) => [value]))('refuses %j and says what it wants', (value) => {
    expect(checkFieldValue(fields[kind], value)).toMatch(/^must be .+, not /);
  });
});

test('the message has the range, the unit and the value', () => {
  expect(checkFieldValue(fields.number, NaN)).toBe('must be a finite number from 0 to 2 m, not NaN');
});

test('an integer field refuses a fraction', () => {
  expect(checkFieldValue(number(1, { integer: true, help }), 1.5)).toMatch(/whole number/);
});

test('a field is hidden when the field it depends on is hidden', () => {
  const table = {
    type: choice('a', ['a', 'b'], { help }),
    fade: choice('x', ['x', 'y'], { help, visibleWhen: { field: 'type', equals: ['b'] } }),
    near: number(1, { help, visibleWhen: { field: 'fade', equals: ['y'] } }),
  };
  const shown = (values: Record<string, string>): boolean => isFieldVisible(table, 'near', (name) => values[name]);
  expect(shown({ type: 'b', fade: 'y' })).toBe(true);
  expect(shown({ type: 'b', fade: 'x' })).toBe(false);
  expect(shown({ type: 'a', fade: 'y' })).toBe(false);
});

test('a field goes by its own type, though another has the same name', () => {
  const other: FieldType = { name: 'even', allows: 'anything', check: () => true };
  expect(checkFieldValue(custom(even, 2, { help }), 1)).toBe('must be an even number, not 1');
  expect(checkFieldValue(custom(other, 2, { help }), 1)).toBeNull();
});
