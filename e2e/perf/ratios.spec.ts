import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';

/**
 * Times of competitors as ratios within one run of the Lab, whose turns alternate: what the thesis concludes, and what it
 * is that stock three pays. On the software rasteriser only ratios that are far from their bound are held; more is held on
 * a GPU (FAROL_GPU=1). Milliseconds are held nowhere.
 */

interface Measured {
  competitor: string;
  series: string;
  index: number;
  frame: { median: number } | null;
  gpu: { median: number } | null;
  added: { ms: number; programs: number | null } | null;
  problem: string | null;
}

interface Lab {
  configurationOf(fragment: string): unknown;
  planOf(configuration: unknown): object;
  run(plan: unknown): Promise<{ rows: Measured[] }>;
}

/** Measures what the fragment of a link says. */
async function measure(page: Page, fragment: string): Promise<Measured[]> {
  await page.goto(`${process.env.FAROL_LAB_URL}?headless`);
  await page.waitForFunction(() => 'lab' in window);
  const { rows } = await page.evaluate(async (fragment) => {
    const { lab } = window as unknown as { lab: Lab };
    return lab.run(lab.planOf(lab.configurationOf(fragment)));
  }, fragment);
  // a browser may have no WebGPU
  const expected = rows.filter(({ competitor }) => competitor !== 'three-webgpu');
  for (const { competitor, problem } of expected) expect(problem, competitor).toBeNull();
  return rows;
}

/** Time of a frame (ms). */
function frameOf(rows: readonly Measured[], competitor: string, index = 0): number {
  const row = rows.find((row) => row.competitor === competitor && row.index === index);
  expect(row?.frame?.median, `frames of ${competitor}, case ${index}`).toBeGreaterThan(0);
  return row!.frame!.median;
}

const times = (rows: readonly Measured[], slow: string, fast: string, index: number): number =>
  frameOf(rows, slow, index) / frameOf(rows, fast, index);

/** Four and 144 lights, the last under ten lights more too. */
const manyLights =
  '#preset=custom&series=benchmarkLights:lights:4,144:n=2&size=128x72&rounds=3&turn=60&changes=yes' +
  '&techniques=stock,multipass,forward,clustered-forward';

test('ten lights more are new programs for stock three, and none for any technique @verify @software', async ({
  page,
}) => {
  const rows = await measure(page, manyLights);
  for (const { competitor, added } of rows) {
    if (competitor === 'stock') expect(added!.programs).toBeGreaterThan(0);
    else expect(added!.programs, competitor).toBe(0);
  }
});

test('many lights cost stock three and a naive multipass many times what they cost by lists and rectangles @long @software', async ({
  page,
}) => {
  const rows = await measure(page, manyLights);
  // stock three walks 144 lights in each pixel, lists of clusters those that reach it
  expect(times(rows, 'stock', 'clustered-forward', 1)).toBeGreaterThan(2);
  expect(times(rows, 'stock', 'clustered-forward', 1)).toBeGreaterThan(
    2 * times(rows, 'stock', 'clustered-forward', 0),
  );
  // the whole scene for each light, against what each light reaches
  expect(times(rows, 'multipass', 'forward', 1)).toBeGreaterThan(2);
  for (const { competitor, added, frame } of rows)
    if (competitor === 'stock') expect(added!.ms).toBeGreaterThan(2 * frame!.median);
});

test.describe('on a graphics card @gpu @long', () => {
  const lights = [10, 100, 500];

  test('forward falls behind deferred as in the thesis', async ({ page }) => {
    const rows = await measure(
      page,
      `#preset=custom&series=sponza:lights:${lights.join()}&size=1280x720&rounds=3&turn=400&techniques=forward,deferred`,
    );
    const behind = lights.map((_, index) => times(rows, 'forward', 'deferred', index));
    expect(behind[2], behind.join()).toBeGreaterThan(1.5);
    expect(behind[2], behind.join()).toBeGreaterThan(behind[0]);
  });
});
