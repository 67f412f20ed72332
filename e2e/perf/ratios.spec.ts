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
  planOf(configuration: unknown): unknown;
  run(plan: unknown): Promise<{ rows: Measured[] }>;
}

/** Measures what the fragment of a link says. */
async function measure(page: Page, fragment: string): Promise<Measured[]> {
  await page.goto(process.env.FAROL_LAB_URL!);
  await page.waitForFunction(() => 'lab' in window);
  const { rows } = await page.evaluate(async (fragment) => {
    const { lab } = window as unknown as { lab: Lab };
    return lab.run(lab.planOf(lab.configurationOf(fragment)));
  }, fragment);
  for (const { competitor, problem } of rows) expect(problem, competitor).toBeNull();
  return rows;
}

/** Time of a frame (ms). */
function frameOf(rows: readonly Measured[], competitor: string, index = 0): number {
  const row = rows.find((row) => row.competitor === competitor && row.index === index);
  expect(row?.frame?.median, `frames of ${competitor}, case ${index}`).toBeGreaterThan(0);
  return row!.frame!.median;
}

test('multipass falls behind deferred as lights become more, and stock three compiles when lights come', async ({ page }) => {
  test.setTimeout(180_000);
  const rows = await measure(
    page,
    '#series=sponza;lights;4,60&size=160x90&competitors=stock,forward,deferred,clustered-forward&rounds=3&turn=200&changes=1',
  );
  const behind = (index: number) => frameOf(rows, 'forward', index) / frameOf(rows, 'deferred', index);
  // 2 with 4 lights, 6 with 60 on the software rasteriser
  expect(behind(1)).toBeGreaterThan(2);
  expect(behind(1)).toBeGreaterThan(1.5 * behind(0));
  // every light reaches every pixel's loop in stock three, and few do by clusters: counts, for times lean on the machine
  const stock = rows.filter(({ competitor }) => competitor === 'stock');
  for (const { added, frame } of stock) {
    expect(added!.programs).toBeGreaterThan(0);
    expect(added!.ms).toBeGreaterThan(2 * frame!.median);
  }
  for (const row of rows.filter(({ competitor }) => competitor !== 'stock')) expect(row.added!.programs).toBe(0);
});
