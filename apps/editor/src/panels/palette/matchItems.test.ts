import { expect, it } from 'vitest';
import { matchItems } from './matchItems';

const items = [
  ['Undo move', 'Edit'],
  ['Duplicate', 'Edit'],
  ['Deferred', 'Technique'],
  ['Tiled deferred', 'Technique'],
  ['Point lights', 'Samples'],
  ['Point light', 'Add'],
].map(([label, group]) => ({ label, group }));
const found = (query: string): string[] => matchItems(items, query).map(({ label }) => label);

it('finds by the letters of a query, whole words first', () => {
  expect(found('')).toEqual(items.map(({ label }) => label));
  expect(found('def')).toEqual(['Deferred', 'Tiled deferred']);
  expect(found('tiled tech')).toEqual(['Tiled deferred']);
  expect(found('technique')).toEqual(['Deferred', 'Tiled deferred']);
  expect(found('plight')).toEqual(['Point light', 'Point lights']);
  expect(found('point light')).toEqual(['Point light', 'Point lights']);
  expect(found('dupl')).toEqual(['Duplicate']);
  expect(found('xyz')).toEqual([]);
});

it('finds by words of the help what no label has, after what one has', () => {
  const list = [
    { label: 'Exposure', group: 'Scene', help: 'Factor of how bright the picture is.' },
    { label: 'Brightness of the file', group: 'Light' },
  ];
  expect(matchItems(list, 'bright').map(({ label }) => label)).toEqual(['Brightness of the file', 'Exposure']);
  expect(matchItems(list, 'ix')).toEqual([]);
});
