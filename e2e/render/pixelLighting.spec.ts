import { expect, test } from '../support/benchTest';

/** Half of what an 8-bit picture can tell. */
const LIMIT = 1 / 255;

const scenes = [
  ...['shadows', 'surroundings', 'field', 'areas', 'cookies'],
  ...['glass', 'orthographic', 'many', 'layered', 'probes'],
];

for (const name of scenes) {
  test(`the shares of a pixel's light add up to it, by every technique: ${name} @verify`, async ({
    benchPage: page,
  }) => {
    test.slow();
    const rows = await page.evaluate(async (scene) => {
      const { Bench, drawn, pixelScenes } = window.testPage;
      const { checkPixels } = await pixelScenes();
      const bench = new Bench(96, 64);
      const all = [];
      for (const technique of drawn) all.push(await checkPixels(bench, scene, technique, 20));
      return all;
    }, name);
    for (const row of rows) {
      console.log(JSON.stringify({ ...row, at: row.difference > 0.002 ? row.at : '' }));
      expect.soft(row.difference, `${row.technique}: ${row.at}`).toBeLessThan(LIMIT);
    }
  });
}
