import { askedScenes, decksOf, recordChanges } from '../support/chance';
import { expect, test } from '../support/benchTest';

const asked = askedScenes();
const { seed: first, count } = asked ?? { seed: 0, count: 8 };

test.describe.configure({ timeout: 480_000 });

for (const seeds of decksOf(first, count, 4))
  test(`scenes that change by chance ${seeds[0]} to ${seeds.at(-1)} as in stock three @verify`, async ({
    benchPage: page,
  }) => {
    const { faults } = await page.evaluate(
      async ([seeds, options]) => (await window.testPage.chance()).runChanges(seeds, options),
      [seeds, asked ? {} : { steps: 12, tries: 1 }] as const,
    );
    recordChanges(faults);
    if (!asked) expect(faults).toEqual([]);
  });
