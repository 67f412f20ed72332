import { expect, test } from '../support/test';

/**
 * Cost of a headset's two eyes beside that of one picture of the size of one: the atrium under 500 moving lights, by an emulated
 * headset. Few lights in a small picture on the software rasteriser, where the times mean little:
 *
 * FAROL_GPU=1 FAROL_TESTS=long npm run e2e -- perf/stereo --workers=1
 */
const onGpu = Boolean(process.env.FAROL_GPU);
// the layer of the emulated headset is as large as the window: two eyes of a headset's size on a GPU
test.use({ viewport: onGpu ? { width: 3360, height: 1760 } : { width: 192, height: 96 } });

const size = onGpu
  ? { lights: 500, shadows: 4, rounds: 7, frames: 20 }
  : { lights: 60, shadows: 2, rounds: 1, frames: 1 };
/** Most that two eyes may cost, of one. */
const MOST = 1.7;

test(`two eyes draw shadow maps once ${onGpu ? '@long' : '@verify'}`, async ({ page, pagesURL }) => {
  test.setTimeout(300_000);
  await page.goto(`${pagesURL}xr.html`);
  await page.waitForFunction(() => 'xrPage' in window);
  const { mono, stereo, eye } = await page.evaluate(async (size) => {
    const { XRBench, xrStereo } = window.xrPage;
    const bench = new XRBench();
    await bench.start('immersive-vr');
    const { timeStereo } = await xrStereo();
    const times = await timeStereo(bench, { technique: 'clustered-forward', ...size });
    await bench.end();
    return times;
  }, size);
  const ratio = (of: 'batch' | 'calls' | 'gpu') => stereo[of]! / mono[of]!;
  const ratios = { batch: ratio('batch'), calls: ratio('calls'), gpu: stereo.gpu === null ? null : ratio('gpu') };
  console.log(JSON.stringify({ ...size, eye, ratios, mono, stereo }));
  expect([mono, stereo].map(({ shadowMaps }) => shadowMaps)).toEqual([1, 1]);
  expect(stereo.passes).toContain('opaque, eye 2');
  if (!onGpu) return;
  expect.soft(ratios.gpu!, 'GPU time').toBeLessThan(MOST);
  expect.soft(ratios.batch, 'frame').toBeLessThan(MOST);
});
