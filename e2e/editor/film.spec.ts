import type { Page } from '@playwright/test';
import { chooseFilm, decode, makeFilm, movingScene, psnr, saveStill } from './film';
import { expect, test } from './sharedEditor';

const openMoving = async (page: Page, seconds: number): Promise<void> => {
  const text = movingScene(seconds);
  expect(await page.evaluate((scene) => window.editor.openFileBytes(scene, { name: null, handle: null }), text)).toBe(
    true,
  );
  await page.evaluate(() => window.editor.viewport.picture.ready);
};

/** Advances the scene by sixtieths of a second, as the user's Step does. */
const step = (page: Page, times: number): Promise<void> =>
  page.evaluate((count) => {
    for (let i = 0; i < count; i++) window.editor.document.simulation.step();
  }, times);

const growing = (values: readonly number[]): boolean => values.every((value, i) => i === 0 || value > values[i - 1]);

test('a film of five frames has five, in order; the scene is as it was', async ({ page }) => {
  await openMoving(page, 0.2);
  const before = await page.evaluate(() => window.editor.serialize());
  await chooseFilm(page, { width: 96, height: 64, to: 0.2, rate: '25', format: 'WebM (VP8)', bitrate: 5 });
  const { times, markers } = await decode(page, await makeFilm(page), 'five', []);
  expect(times).toEqual([0, 0.04, 0.08, 0.12, 0.16]);
  expect(growing(markers), markers.join()).toBe(true);
  expect(await page.evaluate(() => window.editor.document.simulation.state)).toBe('stopped');
  expect(await page.evaluate(() => window.editor.serialize())).toBe(before);
});

test('every frame of a film is a still of its time, however slow the machine @verify', async ({ page }) => {
  await openMoving(page, 1);
  await chooseFilm(page, { width: 320, height: 180, to: 1, rate: '30', format: 'MP4 (H.264)', bitrate: 20 });
  const film = await decode(page, await makeFilm(page), 'film');
  expect(film.size).toEqual([320, 180]);
  expect(film.times).toEqual(Array.from({ length: 30 }, (_, i) => i / 30));
  expect(growing(film.markers), film.markers.join()).toBe(true);

  // a machine of a fifth of the speed, whose encoder takes its time
  const session = await page.context().newCDPSession(page);
  await session.send('Emulation.setCPUThrottlingRate', { rate: 5 });
  await page.evaluate(() => {
    const { encode } = VideoEncoder.prototype;
    VideoEncoder.prototype.encode = function slowly(...frame) {
      for (const end = performance.now() + 40; performance.now() < end;);
      encode.apply(this, frame);
    };
  });
  await chooseFilm(page, { width: 320, height: 180, to: 1, rate: '30', format: 'MP4 (H.264)', bitrate: 20 });
  const slow = await decode(page, await makeFilm(page), 'slow');
  await session.send('Emulation.setCPUThrottlingRate', { rate: 1 });
  expect(slow.times).toEqual(film.times);
  const differing = await page.evaluate(() =>
    window.films.slow.flatMap((frame, i) => (frame.some((byte, k) => byte !== window.films.film[i][k]) ? [i] : [])),
  );
  expect(differing, 'frames that differ from those of the faster machine').toEqual([]);

  const ratios: number[] = [];
  for (let frame = 0; frame < 30; frame++) {
    if (frame > 0) await step(page, 2);
    ratios.push(await psnr(page, 'film', frame, await saveStill(page, 320, 180)));
  }
  await page.evaluate(() => window.editor.document.simulation.stop());
  expect(Math.min(...ratios), ratios.map((each) => each.toFixed(1)).join()).toBeGreaterThan(38);
  // and of no other time
  expect(await psnr(page, 'film', 29, await saveStill(page, 320, 180))).toBeLessThan(30);
});

test('ten seconds of 1080p at 60 frames a second: 600 frames, each a still of its time @gpu @verify', async ({
  page,
}) => {
  test.setTimeout(540_000);
  await openMoving(page, 10);
  await chooseFilm(page, { width: 1920, height: 1080, to: 10, rate: '60', bitrate: 40 });
  const made = await makeFilm(page, 300_000);
  const compared = [0, 100, 200, 300, 400, 500, 599];
  const { times, markers, size } = await decode(page, made, 'long', compared);
  expect(size).toEqual([1920, 1080]);
  expect(times.length).toBe(600);
  times.forEach((time, i) => expect(Math.abs(time - i / 60), `frame ${i}`).toBeLessThan(6e-4));
  expect(growing(markers), 'the marker moves on in each frame').toBe(true);
  // as far from frame to frame as the clip takes it: none is there twice, none is missing
  const way = (markers[599] - markers[0]) / 599;
  const errors = markers.map((marker, i) => Math.abs(marker - markers[0] - i * way));
  expect(Math.max(...errors), 'pixels beside where the marker belongs').toBeLessThan(way / 2);
  let before = 0;
  for (const frame of compared) {
    await step(page, frame - before);
    before = frame;
    const still = await saveStill(page, 1920, 1080);
    expect(await psnr(page, 'long', frame, still), `frame ${frame} against a still of its time`).toBeGreaterThan(36);
  }
});

test('what a browser does not encode is said with its mend; Escape gives a film up @verify', async ({ page }) => {
  await openMoving(page, 60);
  await chooseFilm(page, { width: 321, height: 180, to: 60, rate: '60', format: 'MP4 (H.264)' });
  const dialog = page.getByRole('dialog', { name: 'Save a film' });
  await expect(dialog.getByRole('status')).toHaveText('MP4 (H.264) needs an even width and height, such as 322 × 180.');
  await expect(dialog.getByRole('button', { name: 'Save', exact: true })).toBeDisabled();
  await dialog.getByLabel('Width', { exact: true }).fill('320');
  await dialog.getByLabel('Width', { exact: true }).press('Enter');
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  const progress = page.getByRole('dialog', { name: 'Making the film' });
  await expect(progress).toContainText(/Frame \d+ of 3600/);
  await page.keyboard.press('Escape');
  await expect(progress).toHaveCount(0);
  await expect.poll(() => page.evaluate(() => window.editor.document.simulation.state)).toBe('stopped');
  const shapes = await page.evaluate(() => {
    const { canvas } = window.editor.viewport;
    return [canvas.width / canvas.height, canvas.clientWidth / canvas.clientHeight];
  });
  expect(shapes[0]).toBeCloseTo(shapes[1], 1);
});
