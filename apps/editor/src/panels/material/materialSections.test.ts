import { materialAssetFields, materialMapNames } from '@farol/engine/fields';
import { expect, it } from 'vitest';
import { materialSections, placementFields } from './materialSections';

it('has each field of a material in one section, except for UV placement of maps', () => {
  const shown = materialSections.flatMap(({ fields }) => fields);
  expect(new Set(shown).size).toBe(shown.length);
  for (const name of shown) expect(materialAssetFields).toHaveProperty(name);
  const placed = new Set(materialMapNames.flatMap(placementFields));
  const others = Object.keys(materialAssetFields).filter((name) => !placed.has(name));
  expect(others.filter((name) => !shown.includes(name))).toEqual([]);
});
