import type { Page } from '@playwright/test';
import type { TechniqueName } from '@farol/renderer';
import type { Bench } from '../pages/Bench';
import type { LightMix, MaterialSceneOptions } from '../pages/materialScene';
import type { Difference } from '../support/images';
import { checkAgreement, hardEdgeLimits } from '../support/agreement';
import { inTurn } from '../support/parts';
import { expect, test } from '../support/test';

const WIDTH = 320;
const HEIGHT = 240;

interface Pair {
  technique: string;
  flat: boolean;
  difference: Difference;
}

interface SharedBench {
  /** Of all scenes of a page: what it has compiled for one of them it need not compile for the next. */
  bench?: Bench;
}

/** Draws a scene by stock three once, and by techniques: all, or in `npm test` those that have their turn. */
async function drawAll(
  page: Page,
  options: Omit<MaterialSceneOptions, 'environment'>,
  environment: boolean,
  turn?: number,
): Promise<Pair[]> {
  const known = await page.evaluate(() => Object.keys(window.testPage.farol.techniques));
  const names = (turn === undefined ? known : inTurn(known, turn, 3)) as TechniqueName[];
  return page.evaluate(
    ([width, height, options, environment, names]) => {
      const { Bench, compareImages, isFlat, materialScene } = window.testPage;
      const bench = ((window as SharedBench).bench ??= new Bench(width, height));
      const map = environment ? bench.environment() : null;
      const { scene, camera } = materialScene(width, height, { ...options, environment: map });
      const stock = bench.stock(scene, camera);
      return names.map((technique) => ({
        technique,
        flat: isFlat(stock),
        difference: compareImages(stock, bench.byTechnique(technique, scene, camera)),
      }));
    },
    [WIDTH, HEIGHT, options, environment, names] as const,
  );
}

function check({ technique, flat, difference }: Pair, name: string, hardEdge = false): void {
  expect(flat, `${name}: stock picture is flat`).toBe(false);
  checkAgreement(technique, difference, name, hardEdge ? hardEdgeLimits(technique) : {});
}

// Ten techniques on a software rasteriser that other tests share.
test.describe.configure({ timeout: 480_000 });

const mixes: LightMix[] = ['point', 'spot', 'directional', 'hemisphere', 'unbounded'];

// one page: what its scenes have in common is compiled once
test('all lit materials and meshes, as in stock three', async ({ benchPage: page }) => {
  await test.step('under 24 lights of mixed kinds, with an environment', async () => {
    for (const pair of await drawAll(page, {}, true)) check(pair, 'mixed');
    for (const pair of await drawAll(page, { onlyDeferred: true }, true, 0)) check(pair, 'only what a G-buffer holds');
    for (const pair of await drawAll(page, { orthographic: true }, true, 1)) check(pair, 'orthographic');
  });
  await test.step('in fog', async () => {
    for (const pair of await drawAll(page, { fog: true }, false, 2)) check(pair, 'fog');
  });
  await test.step('under lights of one kind', async () => {
    for (const [turn, mix] of mixes.entries())
      for (const pair of await drawAll(page, { mix }, false, turn)) check(pair, mix);
    // few: stock three has each in the text of its shaders
    for (const pair of await drawAll(page, { mix: 'area', count: 4 }, false, 0)) check(pair, 'area');
    // only the edge may differ where a position is rebuilt
    for (const pair of await drawAll(page, { mix: 'spot', penumbra: 0 }, false, 2)) check(pair, 'hard edges', true);
  });
});
