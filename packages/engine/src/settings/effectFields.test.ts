import { expect, test } from 'vitest';
import { effectFields } from './effectFields';
import { fogFields, skyFields } from './pictureFields';

test('settings of effects are named as no setting of sky or fog is', () => {
  const others = { ...skyFields, ...fogFields };
  expect(Object.keys(effectFields).length).toBeGreaterThan(10);
  expect(Object.keys(effectFields).filter((name) => Object.hasOwn(others, name))).toEqual([]);
});
