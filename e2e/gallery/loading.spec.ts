import { expect, test } from '../support/test';

/** Counts of WebGL's work in the page, kept by `countWork`. */
interface Work {
  /** Addresses that had been fetched when the page drew first. */
  fetched?: string[];
  /** Programs linked. */
  linked: number;
  /** Programs that drew in the frame drawn last. */
  drawn: Set<WebGLProgram>;
}

/** Page of an example, with its counts. */
interface LoadedWindow {
  live: Promise<{ farol: { ready: Promise<void> } }>;
  work: Work;
}

function countWork(): void {
  const { prototype } = WebGL2RenderingContext;
  const { linkProgram, useProgram } = prototype;
  const work: Work = { linked: 0, drawn: new Set() };
  Object.assign(window, { work });
  let program: WebGLProgram | null = null;
  prototype.linkProgram = function (linked) {
    work.linked++;
    linkProgram.call(this, linked);
  };
  prototype.useProgram = function (used) {
    program = used;
    useProgram.call(this, used);
  };
  for (const name of ['drawArrays', 'drawElements'] as const) {
    const draw = prototype[name] as (...values: number[]) => void;
    prototype[name] = function (this: WebGL2RenderingContext, ...values: number[]) {
      work.fetched ??= performance.getEntriesByType('resource').map(({ name: address }) => address);
      if (program !== null) work.drawn.add(program);
      draw.apply(this, values);
    };
  }
  const frames = requestAnimationFrame;
  window.requestAnimationFrame = (draw) =>
    frames((time) => {
      work.drawn.clear();
      draw(time);
    });
}

test('an example is drawn once its code is there, fetched at once, by the programs that it keeps', async ({ page }) => {
  await page.addInitScript(countWork);
  await page.goto('./index.html?gallery/first-lamp');
  await page.waitForFunction(() => 'live' in window);
  const { late, rounds, linked, drawn } = await page.evaluate(async () => {
    const { live, work } = window as unknown as LoadedWindow;
    await (
      await live
    ).farol.ready;
    const scripts = (performance.getEntriesByType('resource') as PerformanceResourceTiming[])
      .filter(({ name }) => /\.[jt]s(\?|$)/.test(name))
      .toSorted((a, b) => a.responseEnd - b.responseEnd);
    // most scripts of which each was asked for after the one before had come
    let rounds = 0;
    let come = -1;
    for (const { startTime, responseEnd } of scripts)
      if (startTime >= come) {
        rounds++;
        come = responseEnd;
      }
    const late = scripts.map(({ name }) => name).filter((name) => !work.fetched!.includes(name));
    return { late, rounds, linked: work.linked, drawn: work.drawn.size };
  });
  expect(late, 'scripts fetched after the first draw').toEqual([]);
  expect(linked, 'programs linked, and drawn with in a frame').toBe(drawn);
  // a page from source has a request for each file
  if (process.env.FAROL_E2E === 'built') expect(rounds, 'requests one after another').toBeLessThanOrEqual(5);
});

/** Programs that the examples with the most to compile link until they are ready, at most. */
const programs = { 'light-kinds': 4, 'night-street': 13, 'played-scene': 13 };

for (const [name, most] of Object.entries(programs))
  test(`${name} links at most ${most} programs until it is ready @verify`, async ({ page }) => {
    await page.addInitScript(countWork);
    await page.goto(`./index.html?gallery/${name}`);
    await page.waitForFunction(() => 'live' in window);
    const linked = await page.evaluate(async () => {
      const { live, work } = window as unknown as LoadedWindow;
      await (
        await live
      ).farol.ready;
      return work.linked;
    });
    expect(linked).toBeLessThanOrEqual(most);
  });
