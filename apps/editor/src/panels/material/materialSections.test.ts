import { materialAssetFields } from '@farol/engine/fields';
import { expect, it } from 'vitest';
import { fieldsLeftOut, materialSections } from './materialSections';

it('has each field of a material in one section', () => {
  expect(fieldsLeftOut()).toEqual([]);
  const shown = materialSections.flatMap(({ fields }) => fields);
  expect(new Set(shown).size).toBe(shown.length);
  for (const name of shown) expect(materialAssetFields).toHaveProperty(name);
});
