import { areaLightCost } from './areaLightCost.long';
import { expect, test } from './perfTest';

/**
 * Cost of area lights beside as many point lights of the same reach: 1,000 of them at 1280 × 720 on a GPU, where the
 * figures mean something, fewer in a small picture on the software rasteriser, where only what is far off is held:
 *
 * FAROL_GPU=1 FAROL_TESTS=long npm run e2e -- perf/areaLights --workers=1
 */
const onGpu = Boolean(process.env.FAROL_GPU);
const most = onGpu ? 4 : 8;

test('rectangle lights cost a few times what point lights of the same reach cost @long', async ({ page }) => {
  test.setTimeout(300_000);
  const size = onGpu
    ? { lights: 1000, width: 1280, height: 720, rounds: 15, frames: 8, gpuTimes: true }
    : { lights: 300, width: 128, height: 72, rounds: 8, frames: 1 };
  const techniques = ['clustered-forward', 'clustered-deferred', 'forward-plus', 'deferred'] as const;
  const rows = await page.evaluate(areaLightCost, { techniques, ...size });
  const figures = rows.map(({ technique, isGpuTime, dark, ...kinds }) => {
    const shading = Object.entries(kinds).map(([kind, time]) => {
      const ratio = (time - dark) / (kinds.points - dark);
      return `${kind} ${(time - dark).toFixed(2)} ms (${ratio.toFixed(2)} ×)`;
    });
    return `${technique}${isGpuTime ? ', GPU' : ''}: without lights ${dark.toFixed(2)} ms; shading: ${shading.join(', ')}`;
  });
  console.log(`${size.lights} lights, ${size.width} × ${size.height}\n${figures.join('\n')}`);
  for (const { technique, dark, points, rectangles } of rows) {
    expect(points, `${technique}: lights are seen`).toBeGreaterThan(dark);
    expect((rectangles - dark) / (points - dark), `${technique}: rectangles by points`).toBeLessThan(most);
  }
});
