import { colour, number } from '@farol/editing/fields';
import { expect, test } from 'vitest';
import { component } from '../core/Component';

class Lamp extends component({
  brightness: number(2, { help: 'How bright.' }),
  tint: colour([1, 0.5, 0], { help: 'Its colour.' }),
}) {
  static override readonly typeName: string = 'Lamp';
}

test('owners of one class hold the same triple until one sets another: a scene has tens of thousands', () => {
  const [a, b] = [new Lamp(), new Lamp()];
  expect(a.get('tint')).toBe(b.get('tint'));
  expect(Object.isFrozen(a.get('tint'))).toBe(true);
  a.tint = [0, 0, 1];
  a.brightness = 3;
  expect([b.tint, b.brightness, new Lamp().tint]).toEqual([[1, 0.5, 0], 2, [1, 0.5, 0]]);
});

test('what every object has is no field', () => {
  for (const name of ['toString', 'constructor', '__proto__', 'hasOwnProperty'])
    expect(() => new Lamp().get(name), name).toThrow('is unknown; the fields are brightness, tint');
});
