import { expect, test } from 'vitest';
import type { Configuration } from '../../plan/Configuration';
import { ownPreset } from '../../own/ownPreset';
import { planOf } from '../../plan/planOf';
import { presets } from '../../plan/presets';
import { configurationOfPlan } from './configurationOfPlan';

test.each(Object.entries(presets))('the preset %s comes back from its plan', (_name, { configuration }) => {
  const plan = planOf(configuration);
  const back = configurationOfPlan(plan);
  expect(back && planOf(back)).toEqual(plan);
});

const quick = presets.quick.configuration;

test('so do another size, other competitors and another effort', () => {
  const wanted: Configuration = {
    ...quick,
    ...{ width: 96, height: 54, competitors: ['stock'], effort: { ...quick.effort, rounds: 7 } },
  };
  expect(configurationOfPlan(planOf(wanted))).toEqual(wanted);
});

test('charts over pixels and others may stand together', () => {
  const series = [...presets.resolution.configuration.series, ...quick.series];
  const plan = planOf({ ...quick, preset: 'custom', series });
  const back = configurationOfPlan(plan);
  expect(back).toMatchObject({ width: 1280, height: 720 });
  expect(back && planOf(back)).toEqual(plan);
});

test('so does that of a scene that was handed over', () => {
  const wanted = ownPreset('Room').configuration;
  const back = configurationOfPlan(planOf(wanted));
  expect(back && planOf(back)).toEqual(planOf(wanted));
});

test('cases that no configuration makes have none', () => {
  const plan = planOf(quick);
  const [first, ...others] = plan.series;
  const cases = first.cases.map((each) => ({ ...each, overdraw: 3 }));
  expect(configurationOfPlan({ ...plan, series: [{ ...first, cases }, ...others] })).toBeNull();
  expect(configurationOfPlan({ ...plan, series: [] })).toBeNull();
});
