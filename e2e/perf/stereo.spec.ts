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
/** Most that two eyes may cost, of one: one after the other, and at once. */
const MOST = { stereo: 1.7, multiview: 1.4 };

test(`two eyes draw shadow maps once, and each object once where both are drawn at once ${onGpu ? '@long' : '@verify'}`, async ({
  page,
  pagesURL,
}) => {
  test.setTimeout(300_000);
  await page.goto(`${pagesURL}xr.html`);
  await page.waitForFunction(() => 'xrPage' in window);
  const { mono, stereo, multiview, eye } = await page.evaluate(async (size) => {
    const { XRBench, xrStereo } = window.xrPage;
    const bench = new XRBench();
    await bench.start('immersive-vr');
    const { timeStereo } = await xrStereo();
    const times = await timeStereo(bench, { technique: 'clustered-forward', ...size });
    await bench.end();
    return times;
  }, size);
  const ratio = (of: 'batch' | 'calls' | 'gpu') => ({
    stereo: stereo[of]! / mono[of]!,
    multiview: multiview[of] === null ? null : multiview[of] / mono[of]!,
  });
  const ratios = { batch: ratio('batch'), calls: ratio('calls'), gpu: stereo.gpu === null ? null : ratio('gpu') };
  console.log(JSON.stringify({ ...size, eye, ratios, mono, stereo, multiview }));
  expect([mono, stereo, multiview].map(({ shadowMaps }) => shadowMaps)).toEqual([1, 1, 1]);
  expect(stereo.passes).toContain('opaque, eye 2');
  expect(multiview.passes).not.toContain('opaque, eye 2');
  // one more writes both eyes to the layer
  expect(multiview.draws).toBeLessThan(mono.draws * 1.1 + 2);
  if (!onGpu) return;
  expect.soft(ratios.gpu!.stereo, 'both eyes by one, GPU time').toBeLessThan(MOST.stereo);
  expect.soft(ratios.batch.stereo, 'both eyes by one').toBeLessThan(MOST.stereo);
  expect.soft(ratios.batch.multiview!, 'both eyes at once by one').toBeLessThan(MOST.multiview);
});
