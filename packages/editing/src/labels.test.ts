import { expect, it } from 'vitest';
import { countLabel, lowerFirst } from './labels';

it('names one object by its name or its type, and several by their number', () => {
  expect(countLabel('Delete', [{ name: 'chest', type: 'Mesh' }])).toBe('Delete chest');
  expect(countLabel('Delete', [{ name: '', type: 'Mesh' }])).toBe('Delete Mesh');
  expect(countLabel('Delete', [{ name: 'a' }, { name: 'b' }])).toBe('Delete 2 objects');
});

it('puts a label into a sentence', () => {
  expect(`Undo ${lowerFirst('Move Box')}`).toBe('Undo move Box');
});
