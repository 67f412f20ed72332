import { expect, it } from 'vitest';
import { countLabel } from './labels';

it('names one object by its name or its type, and several by their number', () => {
  expect(countLabel('Deleted', [{ name: 'chest', type: 'Mesh' }])).toBe('Deleted chest');
  expect(countLabel('Deleted', [{ name: '', type: 'Mesh' }])).toBe('Deleted Mesh');
  expect(countLabel('Deleted', [{ name: 'a' }, { name: 'b' }])).toBe('Deleted 2 objects');
});
