import { builtinComponents } from '@farol/engine';
import { expect, test } from 'vitest';
import { componentIcon } from './componentIcons';

test('the icon that a component names is one of the editor’s, a plain one where it is not', () => {
  for (const type of builtinComponents.types.values())
    expect([type.typeName, componentIcon(type)]).toEqual([type.typeName, type.icon]);
  expect(componentIcon({ icon: 'toString' })).toBe('object');
});
