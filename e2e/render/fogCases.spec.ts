import { expect, test } from '../support/benchTest';

const lights = [
  'rectangle',
  'disc',
  'tube',
  'spot light',
  'spot light with a map',
  'spot light with a photometric profile',
] as const;
/** A G-buffer, and lists over forward shading. */
const techniques = ['deferred', 'clustered-forward'] as const;

for (const light of lights)
  test(`fog in the light of a ${light} is what a march of 512 steps gives @verify`, async ({ benchPage: page }) => {
    const { psnr, brightest } = await page.evaluate(async (name) => {
      const { fogByLight } = await window.testPage.fogCases();
      return fogByLight(name);
    }, light);
    test.info().annotations.push({ type: 'dB', description: psnr.toFixed(1) });
    expect(brightest).toBeGreaterThan(0.05);
    expect(psnr).toBeGreaterThanOrEqual(38);
  });

/** Least PSNR (dB). */
const hosts = {
  'a viewport and scissor of a larger target': 60,
  'an array of cameras': 60,
  'a cube camera': 60,
  'a multisampled target': 45,
  'three’s composer': 80,
  'pmndrs’ composer': 80,
  'another size, and froxels of another number': 80,
  'logarithmic depth': 50,
  'reversed depth': 50,
  'the tiles of a larger picture': 45,
} as const;

for (const [name, least] of Object.entries(hosts))
  test(`fog in ${name} is that of the whole target @verify`, async ({ benchPage: page }) => {
    const found = await page.evaluate(
      async ([host, names]) => {
        const { fogInHost } = await window.testPage.fogHosts();
        const results: [string, number][] = [];
        for (const technique of names) results.push([technique, (await fogInHost(host, technique)).psnr]);
        return results;
      },
      [name as keyof typeof hosts, techniques] as const,
    );
    for (const [technique, psnr] of found) expect.soft(psnr, technique).toBeGreaterThan(least);
  });

test('fog is left out for an orthographic camera, and a warning says so once @verify', async ({
  benchPage: page,
  watch,
}) => {
  const largest = await page.evaluate(async () => {
    const { fogOrthographic } = await window.testPage.fogHosts();
    return fogOrthographic('clustered-forward');
  });
  expect(largest).toBe(0);
  expect(watch.forgive(/volumetric fog is left out.*use a PerspectiveCamera/)).toBe(1);
});

for (const technique of techniques)
  test(`fog lies before transparent things as their blending asks, by ${technique} @verify`, async ({
    benchPage: page,
  }) => {
    test.slow();
    const found = await page.evaluate(async (name) => {
      const { fogBefore, veilNames } = await window.testPage.fogHosts();
      return veilNames.map((veil) => ({ veil, ...fogBefore(veil, name) }));
    }, technique);
    expect(found.length).toBeGreaterThan(10);
    for (const { veil, psnr, covered } of found) {
      expect.soft(covered, veil).toBeGreaterThan(60);
      expect.soft(psnr, veil).toBeGreaterThan(45);
    }
  });
