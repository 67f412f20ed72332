import type { Page } from '@playwright/test';
import type { TechniqueName } from '@farol/renderer';
import type { Bench } from '../pages/Bench';
import type { LightMix, MaterialSceneOptions } from '../pages/materialScene';
import type { Difference } from '../support/images';
import { byExtent, isWhole } from '@farol/tools/extent';
import { checkAgreement, hardEdgeLimits } from '../support/agreement';
import { parts } from '../support/parts';
import { expect, test } from '../support/benchTest';

const WIDTH = 320;
const HEIGHT = 240;

interface Pair {
  technique: string;
  flat: boolean;
  difference: Difference;
}

interface SharedBench {
  /** Bench of all scenes of a page: programs that one compiled need not be compiled for the next. */
  bench?: Bench;
}

/** Draws a scene by stock three once, and by every technique. */
async function drawAll(
  page: Page,
  options: Omit<MaterialSceneOptions, 'environment' | 'part'>,
  environment: boolean,
): Promise<Pair[]> {
  return page.evaluate(
    ([width, height, options, environment]) => {
      const { Bench, compareImages, families, farol, isFlat, isSlice, materialScene } = window.testPage;
      const bench = ((window as SharedBench).bench ??= new Bench(width, height));
      const map = environment ? bench.environment() : null;
      const names = Object.keys(farol.techniques) as TechniqueName[];
      // in the slice a quarter of the meshes by each technique but 'auto', which is one of them; all meshes by each family
      const every = isSlice ? 4 : 1;
      const turns = families.flatMap((family) => family.map((name, turn) => [name, turn % every] as const));
      return Array.from({ length: every }, (_, which) => which).flatMap((which) => {
        const part = [which, every] as const;
        const { scene, camera } = materialScene(width, height, { ...options, environment: map, part });
        const stock = bench.stock(scene, camera);
        const drawnBy = isSlice ? turns.filter(([, turn]) => turn === which).map(([name]) => name) : names;
        return drawnBy.map((technique) => ({
          technique,
          flat: isFlat(stock),
          difference: compareImages(stock, bench.byTechnique(technique, scene, camera)),
        }));
      });
    },
    [WIDTH, HEIGHT, options, environment] as const,
  );
}

function check({ technique, flat, difference }: Pair, name: string, hardEdge = false): void {
  expect(flat, `${name}: stock picture is flat`).toBe(false);
  checkAgreement(technique, difference, name, hardEdge ? hardEdgeLimits(technique) : {});
}

// Ten techniques on a software rasteriser that other tests share.
test.describe.configure({ timeout: 480_000 });

interface Variant {
  readonly name: string;
  readonly options?: Omit<MaterialSceneOptions, 'environment' | 'part'>;
  readonly environment?: boolean;
  /** Only the edge may differ where a position is rebuilt. */
  readonly hardEdge?: boolean;
}

const mixes: LightMix[] = ['point', 'spot', 'directional', 'hemisphere', 'unbounded'];
const variants: readonly Variant[] = [
  // stock three has each light in the text of its shaders: with 10 there is one of each kind
  {
    name: 'lights of mixed kinds, with an environment',
    options: { count: byExtent({ slice: 10, verify: 24 }) },
    environment: true,
  },
  { name: 'only what a G-buffer holds', options: { onlyDeferred: true }, environment: true },
  { name: 'orthographic', options: { orthographic: true }, environment: true },
  { name: 'fog', options: { fog: true } },
  ...mixes.map((mix) => ({ name: mix, options: { mix } })),
  // few: stock three has each in the text of its shaders
  { name: 'area', options: { mix: 'area', count: 4 } },
  { name: 'hard edges', options: { mix: 'spot', penumbra: 0 }, hardEdge: true },
];

// a part is one page: what its scenes have in common is compiled once
for (const [part, listed] of parts(isWhole ? variants : variants.slice(0, 1), 1).entries()) {
  test(`all lit materials and meshes by every technique, as in stock three, part ${part + 1}`, async ({
    benchPage: page,
  }) => {
    // the page may be that of a test before, whose benches are gone
    await page.evaluate(() => void delete (window as SharedBench).bench);
    for (const { name, options = {}, environment = false, hardEdge = false } of listed) {
      await test.step(name, async () => {
        for (const pair of await drawAll(page, options, environment)) check(pair, name, hardEdge);
      });
    }
  });
}
