import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { drop } from '../support/drop';
import { expect, test } from '../support/test';
import { labRun, runFile } from './labRun';

test.use({ reducedMotion: 'reduce', viewport: { width: 1040, height: 720 } });

const laptop = labRun({ id: 'laptop', name: 'Laptop', device: 'Laptop GPU', factor: 1 });
const phone = labRun({ id: 'phone', name: 'Phone', device: 'Phone GPU', factor: 4 });

const library = (page: Page) => page.getByRole('region', { name: 'Kept runs' });

/** What an entry of the export menu gives. */
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
  expect(drawings.bytes.toString('latin1')).toMatch(/^PK[^]*sponza-lights\.svg<svg /);
  const pictures = await exported(page, 'PNG');
  expect(pictures.bytes.toString('latin1')).toMatch(/^PK[^]*sponza-lights\.png\x89PNG/);

  // deleted, back again, deleted
  await library(page).getByRole('button', { name: 'Delete Old laptop' }).click();
  await expect(library(page).getByRole('button', { name: 'Undo' })).toBeFocused();
  await page.keyboard.press('Enter');
  await library(page).getByRole('button', { name: 'Delete Old laptop' }).click();
  await expect(library(page).getByText('Deleted “Old laptop”.')).toBeVisible();
  await expect(library(page).getByRole('button', { name: 'Old laptop', exact: true })).toHaveCount(0);

  // what was exported is the run again, and beside another machine's
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
  await expect(library(page).getByText(/^laptop\.json: .* lets this page store nothing/)).toBeVisible();
  await expect(page.getByRole('heading', { name: 'Laptop', exact: true })).toBeVisible();
  expect((await exported(page, 'JSON')).name).toBe('farol-lab-laptop-2026-11-22.json');
});
