import { budgetOf, drawsByLight } from './budgets';
import { expect, test } from './perfTest';

const OBJECTS = 25;

test('draw calls and passes stay within each technique’s formula, and do not grow with the lights', async ({
  page,
}) => {
  const measured = await page.evaluate((objects) => {
    const { perf } = window;
    perf.drawNothing(); // the calls are counted all the same
    return perf.techniques.flatMap((technique) =>
      [150, 300].map((lights) => {
        const world = perf.world(technique, { objects, lights, spots: 30 });
        for (let i = 0; i < 3; i++) world.draw(); // auto may look at a frame before it picks
        const { draws } = world.count();
        const { info } = world.farol;
        const result = {
          ...{ technique, drawn: info.technique, lights, draws, told: info.drawCalls },
          ...{ passes: info.passes.map(({ name }) => name), visible: info.lights.visible },
        };
        world.dispose();
        return result;
      }),
    );
  }, OBJECTS);

  for (const { technique, drawn, lights, draws, told, passes, visible } of measured) {
    const name = `${technique}, ${lights} lights`;
    const budget = budgetOf(drawn);
    // one directional light reaches everything, every other light one box
    const most = budget.draws({ objects: OBJECTS, pairs: OBJECTS + lights });
    expect(visible, `${name}: lights drawn`).toBe(lights + 1);
    expect(told, `${name}: draw calls`).toBeLessThanOrEqual(most);
    expect(told, `${name}: draw calls, every object once`).toBeGreaterThanOrEqual(OBJECTS);
    expect(draws, `${name}: draw calls as WebGL counts them`).toBe(told);
    expect(passes.length, `${name}: passes ${passes.join(', ')}`).toBeLessThanOrEqual(budget.passes);
  }
  for (const { technique, told, drawn } of measured.filter(({ lights }) => lights === 150)) {
    const more = measured.find((other) => other.technique === technique && other.lights === 300)!;
    if (more.drawn !== drawn || drawsByLight.has(drawn)) continue; // auto may pick another
    expect(more.told, `${technique}: draw calls under 300 lights and under 150`).toBe(told);
  }
});
