import { expect, it } from 'vitest';
import { type Outcome, runStages } from './runStages.mjs';
import { stagePlan } from './stagePlan.mjs';

type Name = keyof typeof stagePlan;

/**
 * Runs the plan with stages that end by hand.
 *
 * @param isSmall - whether on a machine with few cores
 */
function running(isSmall: boolean) {
  const under = new Map<string, (isWell: boolean) => void>();
  const stages = Object.fromEntries(
    Object.entries(stagePlan).map(([name, stage]) => {
      const run = (): Promise<boolean> => new Promise((resolve) => under.set(name, resolve));
      return [name, { ...stage, run }];
    }),
  );
  let ended: Record<string, Outcome> | null = null;
  const whole = runStages(stages, { isSmall }).then((outcomes) => (ended = outcomes));
  return {
    whole,
    /** Ends a stage. @returns names of those that run then */
    async end(name: Name, isWell = true): Promise<string[]> {
      under.get(name)!(isWell);
      under.delete(name);
      for (let turn = 0; turn < 20; turn++) await Promise.resolve();
      return [...under.keys()];
    },
    under: () => [...under.keys()],
    isOver: () => ended !== null,
  };
}

it('a missing Chromium is fetched beside what needs none; browser tests have a small machine for themselves', async () => {
  const { under, end, whole } = running(true);
  expect(under()).toEqual(['chromium', 'types', 'lint', 'unit']);
  expect(await end('types')).toEqual(['chromium', 'lint', 'unit', 'build']);
  expect(await end('lint')).toEqual(['chromium', 'unit', 'build']);
  expect(await end('build')).toEqual(['chromium', 'unit']);
  expect(await end('chromium')).toEqual(['unit', 'packages']);
  expect(await end('unit')).toEqual(['packages']);
  expect(await end('packages')).toEqual(['browser']);
  await end('browser');
  expect(new Set(Object.values(await whole))).toEqual(new Set(['passed']));
});

it('where Chromium cannot be had all other stages run, and those that need it are left out', async () => {
  const { end, whole, isOver } = running(true);
  await end('chromium', false);
  for (const name of ['types', 'lint', 'unit', 'build'] as const) await end(name);
  expect(isOver()).toBe(true);
  expect(await whole).toEqual({
    ...{ types: 'passed', lint: 'passed', unit: 'passed', build: 'passed' },
    ...{ chromium: 'failed', packages: 'left out', browser: 'left out' },
  });
});

it('on a large machine all that needs nothing starts at once', async () => {
  const { under, end } = running(false);
  expect(under()).toEqual(['chromium', 'types', 'lint', 'unit']);
  expect(await end('types')).toEqual(['chromium', 'lint', 'unit', 'build']);
});
