import { expect, test } from 'vitest';
import type { FieldTarget, FieldValue } from './FieldTarget';
import { SetFields } from './SetFields';

/** Has the field `size` as long as `kind` is 'box'. */
class Shape {
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
