import { expect, test } from 'vitest';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';
import { ownPreset, usesOwnScene } from './ownPreset';

test('measures the own scene with its own lights in three sizes', () => {
  const { label, configuration } = ownPreset('Room');
  expect(label).toBe('Room');
  expect(usesOwnScene(configuration)).toBe(true);
  const [series] = planOf(configuration).series;
  expect(series.cases.map(({ lights, width }) => [lights, width])).toEqual([
    [null, 639],
    [null, 1280],
    [null, 1920],
  ]);
});

test('no other preset does', () => {
  for (const { configuration } of Object.values(presets)) expect(usesOwnScene(configuration)).toBe(false);
});
