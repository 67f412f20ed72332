import type { LazyPart } from '@farol/renderer';
import type { Page } from '@playwright/test';
import type { LateCase } from '../pages/lateCases';
import { hold, openLazy } from '../support/lateCode';
import { inTurn } from '../support/parts';
import { expect, test } from '../support/test';

declare global {
  interface Window {
    late: LateCase;
  }
}

const partsOf = (page: Page): Promise<readonly LazyPart[]> =>
  page.evaluate(() => window.testPage.farol.FarolRenderer.parts);

async function checkLate(page: Page, part: LazyPart): Promise<void> {
  // what the test itself needs is there
  await page.evaluate(async (part) => {
    const { farol, nodeScene } = window.testPage;
    if (part === 'nodes') await nodeScene();
    if (part !== 'warm-up') await farol.FarolRenderer.preload(['warm-up']);
  }, part);
  const release = await hold(page);
  const pending = await page.evaluate(async (part) => {
    window.late = await window.testPage.LateCase.of(part);
    return window.late.drawFrames();
  }, part);
  expect(pending, 'info.pending').toContain(part);
  const wait = page.evaluate(() => window.late.wait());
  expect(await page.evaluate(() => window.late.isReady), 'ready while the code is held').toBe(false);
  release();
  await wait;
  const differences = await page.evaluate(() => window.late.differences());
  expect(differences, 'the frame after which it is ready, and two more').toEqual([0, 0, 0]);
}

/** A quarter of the parts, shadow maps among them, in `npm test`. */
for (const [turns, title] of [
  [[0], 'a quarter'],
  [[1, 2, 3], 'the others @verify'],
] as const) {
  test(`a part of the code that comes late: ready waits for it, and frames from then on are as if it had been there, ${title}`, async ({
    page,
    pagesURL,
  }) => {
    await openLazy(page, pagesURL);
    for (const part of (await partsOf(page)).filter((_, i) => turns.some((turn) => turn === i % 4))) {
      await test.step(part, async () => {
        await openLazy(page, pagesURL);
        await checkLate(page, part);
      });
    }
  });
}

test('after compileAsync the first frame on the canvas lacks no code and compiles nothing, whatever part it needs', async ({
  page,
  pagesURL,
}) => {
  await openLazy(page, pagesURL);
  // in the slice another third of the parts than above
  const parts = inTurn(await partsOf(page), 1, 3);
  const results = await page.evaluate(async (parts) => {
    const { LateCase } = window.testPage;
    const results: [string, { pending: readonly string[]; programs: number }][] = [];
    for (const part of parts) results.push([part, await (await LateCase.of(part)).drawCompiled()]);
    return results;
  }, parts);
  expect(results.length).toBeGreaterThan(1);
  for (const [part, frame] of results) expect.soft(frame, part).toEqual({ pending: [], programs: 0 });
});

test('what will need code has it fetched before the first frame', async ({ page, pagesURL }) => {
  await openLazy(page, pagesURL);
  const seen: string[] = [];
  page.on('request', (request) => seen.push(request.url()));
  // pattern of the fetched files, by the feature that needs them
  const needs = {
    "'auto'": /clusteredPasses/,
    'a technique': /multipass/,
    'a view': /\/views/,
    'a LightField': /makeLightFields/,
    'an area light': /area-lights/,
  };
  for (const [need, file] of Object.entries(needs)) {
    const isFetched = (): boolean => seen.some((url) => file.test(url));
    expect(isFetched(), `${need}, before`).toBe(false);
    await page.evaluate((need) => {
      const { Bench, lightFields, setLightOptions, three } = window.testPage;
      // 'auto' is the default
      if (need === "'auto'") new Bench(8, 8);
      if (need === 'a technique') new Bench(8, 8).farol.technique = 'forward';
      if (need === 'a view') new Bench(8, 8).farol.view = 'normal';
      if (need === 'a LightField') new lightFields.LightField(1);
      if (need === 'an area light') setLightOptions(new three.RectAreaLight(), { shape: 'disc' });
    }, need);
    await expect.poll(isFetched, need).toBe(true);
  }
});

test('shadow maps that are asked for once are drawn also where their code comes after three has taken the request back @verify', async ({
  page,
  pagesURL,
}) => {
  await openLazy(page, pagesURL);
  const release = await hold(page);
  const names = inTurn(await page.evaluate(() => window.testPage.LateCase.once), 0, 2);
  await page.evaluate(async (names) => {
    const { LateCase } = window.testPage;
    const lates = await Promise.all(names.map((name) => LateCase.of(name)));
    for (const late of lates) late.drawFrames();
    Object.assign(window, { lates });
  }, names);
  release();
  const results = await page.evaluate(async () => {
    const { lates } = window as unknown as { lates: LateCase[] };
    const results: [string, number, number[]][] = [];
    for (const late of lates) {
      await late.wait();
      const differences = await late.differences();
      results.push([late.name, late.maps, differences]);
    }
    return results;
  });
  for (const [name, maps, differences] of results) {
    expect.soft(maps, name).toBeGreaterThan(0);
    expect.soft(differences, name).toEqual([0, 0, 0]);
  }
});
