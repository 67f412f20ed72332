import { expect, it } from 'vitest';
import { runStages, type Stage } from './runStages.mjs';

/** Stages that write down when they begin and end; each ends once `turns` other microtasks have had their turn. */
function world(list: Record<string, Omit<Stage, 'run'> & { turns?: number; fails?: boolean }>) {
  const seen: string[] = [];
  const stages = Object.fromEntries(
    Object.entries(list).map(([name, { turns = 1, fails = false, ...stage }]) => {
      const run = async (): Promise<boolean> => {
        seen.push(`+${name}`);
        for (let i = 0; i < turns; i++) await Promise.resolve();
        seen.push(`-${name}`);
        if (fails) throw new Error(name);
        return true;
      };
      return [name, { ...stage, run }] as const;
    }),
  );
  return { seen, stages };
}

it('runs side by side what need not wait, and in turn what needs another or a small machine whole', async () => {
  const list = {
    browser: { turns: 9 },
    types: { turns: 3 },
    unit: { alone: true },
    build: {},
    pages: { needs: ['build', 'browser'] },
  };
  const small = world(list);
  expect(await runStages(small.stages, { isSmall: true })).toMatchObject({ unit: 'passed', pages: 'passed' });
  expect(small.seen.slice(0, 3)).toEqual(['+browser', '+types', '+build']);
  expect(small.seen.indexOf('+pages')).toBeGreaterThan(small.seen.indexOf('-browser'));
  const unit = small.seen.indexOf('+unit');
  expect(small.seen[unit + 1]).toBe('-unit');

  const large = world(list);
  await runStages(large.stages, { isSmall: false });
  expect(large.seen.slice(0, 4)).toEqual(['+browser', '+types', '+unit', '+build']);
});

it('goes on after a stage that fails, and leaves out what needs it', async () => {
  const { stages } = world({
    build: { fails: true },
    pages: { needs: ['build'] },
    browser: { needs: ['pages'] },
    unit: {},
  });
  const outcomes = await runStages(stages, { isSmall: true });
  expect(outcomes).toEqual({ build: 'failed', pages: 'left out', browser: 'left out', unit: 'passed' });
});

it('takes what is not asked for as done, and names stages that wait for one another', async () => {
  const { stages } = world({ pages: { needs: ['build'] } });
  expect(await runStages(stages, { isSmall: true })).toEqual({ pages: 'passed' });
  const circle = world({ a: { needs: ['b'] }, b: { needs: ['a'] } });
  await expect(runStages(circle.stages, { isSmall: true })).rejects.toThrow('wait for one another: a, b');
});
