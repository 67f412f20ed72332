import type { Light } from 'three';
import { expect, test } from './perfTest';

test('after its first frame no technique compiles anything, whatever comes, goes or is chosen', async ({ page }) => {
  const steps = await page.evaluate(() => {
    const { perf, farolCounters, testPage } = window;
    const { three } = testPage;
    const world = perf.world('forward', { objects: 4, lights: 4, directional: 0 });
    const steps: { technique: string; step: string; programs: number }[] = [];
    const run = (step: string, work: () => void) => {
      const before = farolCounters.programs;
      work();
      steps.push({ technique: world.farol.technique, step, programs: farolCounters.programs - before });
    };
    for (const technique of perf.techniques) {
      world.farol.technique = technique;
      run('first', world.draw);
    }
    const kinds: Record<string, () => Light> = {
      point: () => new three.PointLight(0xffffff, 0.1, 2),
      unbounded: () => new three.PointLight(0xffffff, 0.1),
      spot: () => new three.SpotLight(0xffffff, 0.1, 2, 0.4),
      directional: () => new three.DirectionalLight(0xffffff, 0.1),
      hemisphere: () => new three.HemisphereLight(0xffffff, 0x000000, 0.1),
    };
    for (const technique of [...perf.techniques, ...perf.techniques.toReversed()]) {
      world.farol.technique = technique;
      run('switched to again', world.draw);
      for (const [kind, make] of Object.entries(kinds)) {
        const added = Array.from({ length: 10 }, make);
        for (const light of added) light.position.set(0, 0, 1);
        run(`10 ${kind} lights added`, () => {
          world.scene.add(...added);
          world.draw();
        });
        run(`10 ${kind} lights removed`, () => {
          world.scene.remove(...added);
          world.draw();
        });
      }
      run('all lights removed', () => {
        world.scene.remove(...world.lights);
        world.draw();
      });
      run('all lights back', () => {
        world.scene.add(...world.lights);
        world.draw();
      });
    }
    return steps;
  });
  const first = steps.filter(({ step }) => step === 'first');
  for (const { technique, programs } of first) {
    // one by one: a program may be shared with the technique before it
    expect(programs, `${technique}: programs of the first frame`).toBeLessThanOrEqual(12);
  }
  expect(first[0].programs, 'the counter sees programs').toBeGreaterThan(0);
  expect(steps.filter(({ step, programs }) => step !== 'first' && programs > 0)).toEqual([]);
});
