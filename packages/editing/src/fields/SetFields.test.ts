import { expect, test } from 'vitest';
import type { FieldValue } from './Field';
import type { FieldTarget } from './FieldTarget';
import { SetFields } from './SetFields';

/** A shape whose field `size` exists while `kind` is 'box'. */
class Shape {
  readonly fields = { kind: {}, size: {} };
  readonly values = new Map<string, FieldValue>([
    ['kind', 'box'],
    ['size', 1],
  ]);
  getAuthored(name: string): FieldValue {
    return this.values.get(name)!;
  }
  set(name: string, value: FieldValue): void {
    if (name === 'size' && this.values.get('kind') !== 'box') throw new Error('size is unknown');
    this.values.set(name, value);
  }
}

test('is undone from its last field to its first, since one may decide which others there are', () => {
  const owner = new Shape() as unknown as FieldTarget;
  const edit = new SetFields('Set', [
    { owner, name: 'size', value: 2 },
    { owner, name: 'kind', value: 'ball' },
  ]);
  edit.do();
  edit.undo();
  expect([owner.getAuthored('kind'), owner.getAuthored('size')]).toEqual(['box', 1]);
  edit.do();
  expect(owner.getAuthored('kind')).toBe('ball');
});

/**
 * A surface with a text that holds all values, of which the field `height` views one: 0 for a missing or invalid value.
 */
class Surface {
  readonly ownerName = 'Surface';
  readonly fields = { values: {}, height: { viewOf: 'values' } };
  values = 'height=-6';
  getAuthored(name: string): FieldValue {
    return name === 'values' ? this.values : Math.max(0, Number(this.values.slice(7)));
  }
  set(name: string, value: FieldValue): void {
    this.values = name === 'values' ? String(value) : `height=${String(value)}`;
  }
}

test('undoes a part of a value as the whole that it was, also one that the part does not allow', () => {
  const owner = new Surface();
  const edit = new SetFields('Set', [{ owner, name: 'height', value: 3 }]);
  expect(edit.isEmpty).toBe(false);
  edit.do();
  expect(owner.values).toBe('height=3');
  const next = new SetFields('Set', [{ owner, name: 'height', value: 4 }]);
  const joined = edit.replaceWith(next)!;
  expect(owner.values).toBe('height=4');
  joined.undo();
  expect(owner.values).toBe('height=-6');
});
