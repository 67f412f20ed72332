import { expect, it } from 'vitest';
import { fogFields, pictureFields, skyFields } from './pictureFields';

it('has no effect whose field takes the place of one of the sky or of the fog that fades with distance', () => {
  const own = { ...skyFields, ...fogFields };
  const replaced = Object.entries(own).filter(([name, field]) => pictureFields[name as keyof typeof own] !== field);
  expect(replaced.map(([name]) => name)).toEqual([]);
});
