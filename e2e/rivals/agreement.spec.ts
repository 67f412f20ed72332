import { expect, test } from '../support/test';
import { materialsScene } from './materialsScene';

interface Case {
  readonly scene: string;
  readonly parameters: { readonly n?: number };
  readonly lights: number | null;
  readonly overdraw?: number;
  /** Bytes of the scene `own`. */
  readonly own?: number[];
}

/** What is used of the stage of apps/lab. */
interface Stage {
  open(name: string, labCase: object, options: object): Promise<{ picture: ImageData; dropped: number }>;
  addLights(name: string): Promise<unknown>;
  setOwnScene(file: Uint8Array): Promise<void>;
  close(name: string): void;
}

/** The page, once it offers its stage. */
interface StageWindow {
  readonly stage: Stage;
}

/** Least peak signal-to-noise ratio (dB): what is left are highlights of single pixels, and 1 of 255 in brightness. */
const least = 38;

const cases: readonly Case[] = [
  ...[10, 100].flatMap((lights) => [
    { scene: 'benchmarkLights', parameters: { n: 5 }, lights },
    { scene: 'temple', parameters: {}, lights },
    { scene: 'sponza', parameters: {}, lights },
  ]),
  { scene: 'sponza', parameters: {}, lights: 10, overdraw: 3 },
  { scene: 'own', parameters: {}, lights: null, own: materialsScene() },
];

for (const one of cases) {
  const { scene, lights, overdraw = 0 } = one;
  const layers = overdraw > 0 ? `, ${overdraw} layers` : '';
  test(`${scene}, ${lights ?? 'its own'} lights${layers}`, async ({ page, watch }) => {
    await page.goto('./stage.html');
    await page.waitForFunction(() => (window as unknown as Partial<StageWindow>).stage);
    const { reference, rivals } = await page.evaluate(compare, one);
    // three says so on the software rasteriser when it compiles many lights
    watch.forgive(/KHR_parallel_shader_compile/);
    expect(reference).toBeGreaterThan(30);
    for (const { name, ratio, dropped } of rivals) {
      console.log(`${name}, ${scene}, ${lights ?? 'its own'} lights: ${ratio.toFixed(1)} dB`);
      expect.soft(ratio, name).toBeGreaterThan(least);
      expect.soft(dropped, name).toBe(0);
    }
  });
}

test('lights that PlayCanvas has no room for are counted, and added ones are drawn', async ({ page }) => {
  await page.goto('./stage.html');
  await page.waitForFunction(() => (window as unknown as Partial<StageWindow>).stage);
  const dropped = await page.evaluate(async () => {
    const { signal } = new AbortController();
    const scene = { name: 'temple', parameters: {} };
    const labCase = { scene, lights: 4000, shadows: 0, overdraw: 0, width: 64, height: 36 };
    const opened = await (window as unknown as StageWindow).stage.open('playcanvas', labCase, {
      signal,
      longestFrame: 60_000,
    });
    await (window as unknown as StageWindow).stage.addLights('playcanvas');
    return opened.dropped;
  });
  expect(dropped).toBeGreaterThan(0);
  expect(dropped).toBeLessThan(1000);
});

test('shadows are refused in a sentence', async ({ page }) => {
  await page.goto('./stage.html');
  await page.waitForFunction(() => (window as unknown as Partial<StageWindow>).stage);
  const messages = await page.evaluate(async () => {
    const { signal } = new AbortController();
    const scene = { name: 'sponza', parameters: {} };
    const labCase = { scene, lights: 10, shadows: 2, overdraw: 0, width: 64, height: 36 };
    const said = [];
    for (const name of ['playcanvas', 'babylon']) {
      said.push(
        await (window as unknown as StageWindow).stage.open(name, labCase, { signal, longestFrame: 60_000 }).then(
          () => 'drawn',
          (error: Error) => error.message,
        ),
      );
    }
    return said;
  });
  expect(messages).toEqual([
    'PlayCanvas’s clustered lights are measured without shadows.',
    'Babylon.js’s clustered lights are measured without shadows.',
  ]);
});

/** Draws a case by stock three and by the other engines. Runs in the page. */
async function compare({ scene, parameters, lights, overdraw = 0, own }: Case) {
  const { stage } = window as unknown as StageWindow;
  if (own) await stage.setOwnScene(new Uint8Array(own));
  const labCase = { scene: { name: scene, parameters }, lights, shadows: 0, overdraw, width: 320, height: 180 };
  const options = { signal: new AbortController().signal, longestFrame: 60_000 };
  const { data } = (await stage.open('stock', labCase, options)).picture;
  stage.close('stock');
  const values = (data.length / 4) * 3;
  const rivals = [];
  for (const name of ['playcanvas', 'babylon']) {
    const { picture, dropped } = await stage.open(name, labCase, options);
    stage.close(name);
    let squares = 0;
    for (let i = 0; i < data.length; i++) if (i % 4 !== 3) squares += (data[i] - picture.data[i]) ** 2;
    rivals.push({ name, ratio: 10 * Math.log10(255 ** 2 / (squares / values)), dropped });
  }
  // a black picture would agree with anything dark
  const reference = data.reduce((sum, value, i) => (i % 4 === 3 ? sum : sum + value), 0) / values;
  return { reference, rivals };
}
