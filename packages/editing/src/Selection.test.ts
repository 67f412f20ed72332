import { expect, it } from 'vitest';
import { Selection } from './Selection';

it('keeps each item once, in the order of choice, and tells of changes alone', () => {
  const selection = new Selection<string>();
  selection.set(['a', 'b', 'a']);
  const { items } = selection;
  expect([items, selection.primary, selection.has('a')]).toEqual([['a', 'b'], 'b', true]);
  selection.set(['a', 'b']);
  expect([selection.changed.revision, selection.items === items]).toEqual([1, true]);
  selection.toggle('a');
  selection.toggle('c');
  expect(selection.items).toEqual(['b', 'c']);
  selection.clear();
  expect([selection.items, selection.primary, selection.changed.revision]).toEqual([[], null, 4]);
});
