import { expect, it } from 'vitest';
import guide from '../../docs/views.md?raw';
import { views } from './views';

it('has every view in the guide, in the order of menus', () => {
  const rows = [...guide.matchAll(/^\| `([a-z-]+)` /gm)].map(([, name]) => name);
  expect(rows).toEqual([...views]);
});
