import { readFile } from 'node:fs/promises';
import { isWhole } from '@farol/tools/extent';
import type { Page } from '@playwright/test';
import { strFromU8, unzipSync } from 'three/addons/libs/fflate.module.js';
import { drop } from '../support/drop';
import { expect, test } from '../support/test';
import { labRun, runFile } from './labRun';

test.use({ reducedMotion: 'reduce', viewport: { width: 1040, height: 720 } });

const laptop = labRun({ id: 'laptop', name: 'Laptop', device: 'Laptop GPU', factor: 1 });
const phone = labRun({ id: 'phone', name: 'Phone', device: 'Phone GPU', factor: 4 });

const library = (page: Page) => page.getByRole('region', { name: 'Saved runs' });

/** Exports the run and returns the downloaded file. */
async function exported(page: Page, format: string) {
  await page.locator('.export-menu summary').click();
  // the open menu lies within the page
  const { scrollWidth, clientWidth } = await page.evaluate(() => {
    const { scrollWidth, clientWidth } = document.documentElement;
    return { scrollWidth, clientWidth };
  });
  expect(scrollWidth).toBe(clientWidth);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page
      .locator('.export-menu')
      .getByRole('button', { name: new RegExp(`^${format} `) })
      .click(),
  ]);
  await expect(page.getByText(`${download.suggestedFilename()} is made.`)).toBeVisible();
  return { name: download.suggestedFilename(), bytes: await readFile(await download.path()) };
}

test('a run is imported, kept, renamed, exported in every form, deleted and compared', async ({ page }) => {
  await page.goto('./');
  const files = page.getByLabel('Runs to import');
  const broken = { ...laptop, rows: laptop.rows.with(1, { ...laptop.rows[1], firstMs: -1 }) };
  await files.setInputFiles(runFile('broken.json', broken));
  await expect(library(page).getByRole('alert')).toHaveText(
    'broken.json: rows[1].firstMs is -1: give a number from 0 to 1000000000 (ms).',
  );
  await files.setInputFiles(runFile('laptop.json', laptop));
  await expect(page.getByRole('heading', { name: 'Laptop', exact: true })).toBeVisible();

  // it is there after a reload
  await page.reload();
  await library(page).getByRole('button', { name: 'Laptop', exact: true }).click();
  await expect(page.getByRole('heading', { name: 'Laptop', exact: true })).toBeVisible();
  await library(page).getByRole('button', { name: 'Rename Laptop' }).click();
  await page.keyboard.type('Old laptop');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('heading', { name: 'Old laptop', exact: true })).toBeVisible();

  const json = await exported(page, 'JSON');
  expect(json.name).toBe('farol-lab-old-laptop-2026-11-22.json');
  expect(JSON.parse(json.bytes.toString())).toEqual({ ...laptop, name: 'Old laptop' });
  const csv = await exported(page, 'CSV');
  expect(csv.bytes.toString().split('\r\n')).toHaveLength(1 + 4 + 1);
  const markdown = await exported(page, 'Markdown');
  expect(markdown.bytes.toString()).toContain('| 100 | 20 | **5** |');
  const drawings = await exported(page, 'SVG');
  expect(drawings.name).toBe('farol-lab-old-laptop-2026-11-22-svg.zip');
  const svg = unzipSync(drawings.bytes)['curve-sponza-lights.svg'];
  expect(strFromU8(svg)).toMatch(/^<svg /);
  if (isWhole) {
    const pictures = await exported(page, 'PNG');
    expect(pictures.bytes.toString('latin1')).toMatch(/^PK[^]*sponza-lights\.png\x89PNG/);
  }

  // deleted, restored, deleted
  await library(page).getByRole('button', { name: 'Delete Old laptop' }).click();
  await expect(library(page).getByRole('button', { name: 'Undo' })).toBeFocused();
  await page.keyboard.press('Enter');
  await library(page).getByRole('button', { name: 'Delete Old laptop' }).click();
  await expect(library(page).getByText('Deleted “Old laptop”.')).toBeVisible();
  await expect(library(page).getByRole('button', { name: 'Old laptop', exact: true })).toHaveCount(0);

  // the exported file is the run, and can be compared with another machine's
  await drop(page, { [json.name]: json.bytes, 'phone.json': JSON.stringify(phone) });
  await library(page).getByRole('checkbox', { name: 'Compare Phone' }).check();
  await library(page).getByRole('checkbox', { name: 'Compare Old laptop' }).check();
  await library(page).getByRole('button', { name: 'Compare two' }).click();
  const comparison = page.getByRole('region', { name: 'Two runs side by side' });
  await expect(comparison.getByRole('row', { name: /Farol: deferred 2 4 the second is 4 × faster/ })).toBeVisible();
  await expect(comparison.getByRole('row', { name: /^100 Farol: forward 80 20 4 / })).toBeVisible();
});

test('without a store the run stays on the page, and a sentence says so', async ({ page }) => {
  await page.addInitScript(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException('denied', 'SecurityError');
    };
  });
  await page.goto('./');
  await page.getByLabel('Runs to import').setInputFiles(runFile('laptop.json', laptop));
  await expect(library(page).getByText(/^laptop\.json: .* does not let this page store data/)).toBeVisible();
  await expect(page.getByRole('heading', { name: 'Laptop', exact: true })).toBeVisible();
  expect((await exported(page, 'JSON')).name).toBe('farol-lab-laptop-2026-11-22.json');
});

interface Headless {
  configurationOf(fragment: string): object;
  planOf(configuration: object): object;
  run(
    plan: object,
    options: object,
  ): Promise<{ complete: boolean; rows: { competitor: string; problem: string | null }[] }>;
  remaining(run: object): { series: object[] };
  files(run: object): { name: string; text: string }[];
}

test('npm run bench finds the Lab without its page', async ({ page }) => {
  await page.goto('./?headless');
  await page.waitForFunction(() => 'lab' in window);
  const told = await page.evaluate(async () => {
    const { lab } = window as unknown as { lab: Headless };
    const tiny = 'series=benchmarkLights:lights:1:n=1&size=64x36&techniques=forward,forward@against';
    let refused = '';
    try {
      lab.configurationOf(tiny);
    } catch (error) {
      refused = (error as Error).message;
    }
    const steps: string[] = [];
    const settings = '&rounds=1&turn=20&changes=no&longest=20000';
    const plan = lab.planOf(lab.configurationOf(tiny.replace(',forward@against', settings)));
    const run = await lab.run(plan, {
      onStep: ({ competitor }: { competitor: string | null }) => competitor && steps.push(competitor),
    });
    return { refused, steps, run, left: lab.remaining(run).series, files: lab.files(run) };
  });
  expect(told.refused).toMatch(/^techniques=forward@against: there is none of that name\. Known are auto, /);
  expect(told.run.rows).toMatchObject([
    { competitor: 'forward', problem: null, frame: { samples: expect.any(Number) } },
  ]);
  expect(told.run.complete).toBe(true);
  expect(told.left).toEqual([]);
  expect(new Set(told.steps)).toEqual(new Set(['forward']));
  const [markdown, ...drawings] = told.files;
  expect(markdown).toMatchObject({ name: 'bench.md', text: expect.stringContaining('| 1 | 1 |') });
  expect(drawings.length).toBeGreaterThan(0);
  for (const { name, text } of drawings)
    expect([name, text]).toEqual([expect.stringMatching(/\.svg$/), expect.stringMatching(/^<svg /)]);
  await expect(page.getByRole('button')).toHaveCount(0);
});
