import { describe, expect, it } from 'vitest';
import type { SeriesChoice } from './Configuration';
import { lightKindNames, shadingNames } from './lightKinds';
import { estimate, planOf } from './planOf';
import { presets } from './presets';

const base = presets.lights.configuration;
const planned = (...series: SeriesChoice[]) => planOf({ ...base, series }).series;
const atrium = (changes: Partial<SeriesChoice>): SeriesChoice => ({
  ...{ scene: 'sponza', n: 1, axis: 'lights', values: [10], lights: 0 },
  ...changes,
});

describe('the kind of lights and the shading', () => {
  it('are points of the scene’s own reach, and materials as they are, where nothing is said', () => {
    const [{ cases, name, label }] = planned(atrium({}));
    expect(cases[0]).toMatchObject({ lights: 10, lightKind: 'points', lightRange: null, shading: 'own' });
    expect([name, label]).toEqual(['sponza-lights', 'Atrium over point lights']);
  });

  it('stand beside another axis, and in its name', () => {
    const [field, rectangles] = planned(
      atrium({ values: [100, 10], lightKind: 'field', lightRange: 1 }),
      atrium({ axis: 'pixels', lights: 7, lightKind: 'rectangles', shading: 'flat' }),
    );
    expect([field.name, field.label]).toEqual(['sponza-lights-field', 'Atrium (a LightField; reach 1 m) over lights']);
    expect(field.cases.map(({ lights, lightKind, lightRange }) => [lights, lightKind, lightRange])).toEqual([
      [10, 'field', 1],
      [100, 'field', 1],
    ]);
    expect(rectangles.name).toBe('sponza-pixels-rectangles-flat');
    expect(rectangles.label).toBe('Atrium (rectangles; flat shading) over pixels of the picture, 7 lights');
    expect(rectangles.cases[0]).toMatchObject({ lightKind: 'rectangles', shading: 'flat' });
  });

  it('are axes too, whose values are places in lists', () => {
    const [kinds, shaded] = planned(
      atrium({ axis: 'kind', values: [2, 0], lights: 1000, lightRange: 2 }),
      atrium({ axis: 'shading', values: [1, 2, 3], lights: 100 }),
    );
    expect(kinds.values.map((value) => lightKindNames[value])).toEqual(['points', 'rectangles']);
    expect(kinds.cases.map(({ lightKind, lights }) => [lightKind, lights])).toEqual([
      ['points', 1000],
      ['rectangles', 1000],
    ]);
    expect(kinds.label).toBe('Atrium (reach 2 m) over kind of lights, 1000 lights');
    expect(shaded.values.map((value) => shadingNames[value])).toEqual(['flat', 'gouraud', 'phong']);
    expect(shaded.cases.map(({ shading }) => shading)).toEqual(['flat', 'gouraud', 'phong']);
  });

  it('are refused where they cannot be', () => {
    const refused = (changes: object) => () => planned(atrium(changes));
    expect(refused({ lightKind: 'lasers' })).toThrow('no lights of the kind lasers: choose one of points, spots, ');
    expect(refused({ shading: 'toon' })).toThrow('no shading toon: choose one of own, flat, gouraud, phong.');
    expect(refused({ lightRange: 0 })).toThrow('Lights cannot reach 0 m: give 0.1 to 100 m');
    expect(refused({ axis: 'kind', values: [6] })).toThrow('6 is not a kind: choose one of points, ');
    expect(refused({ axis: 'shadows', lights: 4, lightKind: 'spots' })).toThrow('only with point lights');
    expect(refused({ scene: 'own', axis: 'pixels', lightKind: 'field' })).toThrow('lights of its own');
  });
});

it('the preset matter has the rows of the issue', () => {
  const { series, label } = planOf(presets.matter.configuration);
  expect(label).toBe('Light and matter');
  const rows = series.flatMap(({ cases }) =>
    cases.map(({ scene, lights, lightKind, lightRange, shading }) => [
      scene.name,
      lights,
      lightKind,
      lightRange,
      shading,
    ]),
  );
  expect(rows).toEqual([
    ['sponza', 20_000, 'particles', null, 'own'],
    ['sponza', 10_000, 'field', 1, 'own'],
    ['sponza', 20_000, 'field', 1, 'own'],
    ['sponza', 5000, 'points', 2, 'own'],
    ['sponza', 5000, 'field', 2, 'own'],
    ['sponza', 1000, 'points', 2, 'own'],
    ['sponza', 1000, 'rectangles', 2, 'own'],
    ['sponza', 100, 'points', null, 'flat'],
    ['sponza', 100, 'points', null, 'gouraud'],
    ['sponza', 100, 'points', null, 'phong'],
  ]);
  expect(new Set(series.map(({ name }) => name)).size).toBe(series.length);
});

describe('the time that a plan takes', () => {
  const effort = { ...base.effort, rounds: 3, turn: 1000, changes: false, limit: null };
  const time = (changes: Partial<typeof base>, values = [10, 20]) =>
    estimate(planOf({ ...base, effort, competitors: ['forward'], ...changes, series: [atrium({ values })] }));
  const one = time({});

  it('is that of its turns, and some to open each case', () => {
    expect(one).toBeGreaterThan(2 * 3 * 1000);
    expect(one).toBeLessThan(2 * 3 * 1000 + 2 * 1000);
  });

  it('grows with cases, competitors, rounds, turns and changes, and ends at its limit', () => {
    expect(time({}, [10, 20, 30, 40])).toBe(2 * one);
    expect(time({ competitors: ['forward', 'deferred', 'three'] })).toBe(3 * one);
    expect(time({ effort: { ...effort, rounds: 4 } })).toBe(one + 2 * 1000);
    expect(time({ effort: { ...effort, turn: 1200 } })).toBe(one + 2 * 3 * 200);
    expect(time({ effort: { ...effort, changes: true } })).toBeGreaterThan(one);
    expect(time({ effort: { ...effort, limit: 5000 } })).toBe(5000);
    expect(time({ effort: { ...effort, limit: 60_000 } })).toBe(one);
  });
});
