/**
 * @typedef {import('playwright-core').BrowserContext} BrowserContext
 * @typedef {import('playwright-core').Page} Page
 * @typedef {{ mode: string, offered: boolean, edits: number, stored: number, kept: number, lost: number, lostMs: number, stallMs: number }} Kill
 *   edits: made in all; stored: last one that the page reported as stored; kept: last one in the offered draft;
 *   lost: count of later ones; lostMs: age of the oldest lost one (ms); stallMs: longest hang of the page (ms)
 */

/** Kinds of edits during which the tab is killed. */
export const killModes = /** @type {const} */ (['steps', 'drag', 'objects', 'slow']);

/** Pause between two steps of a drag, and between two other edits (ms). */
const DRAG_STEP = 16;
const STEP = 60;

/** Longest stretch of edits that a kill may lose (ms), besides the time for which the page was blocked. */
export const MOST_LOST = 1000;

/**
 * Kills a tab of the editor while edits go on, and looks what the next tab is offered.
 *
 * @param {BrowserContext} context - one that is kept: its store outlives the tab
 * @param {object} options
 * @param {string} options.url - of the editor
 * @param {() => number} options.random
 * @param {(typeof killModes)[number]} options.mode
 * @returns {Promise<Kill>}
 */
export async function killTab(context, { url, random, mode }) {
  const page = await openEditor(context, url);
  /** @type {{ n: number, time: number }[]} */
  const edits = [];
  let [stored, stallMs] = [0, 0];
  /** @type {{ time: number, ms: number }[]} */
  const stalls = [];
  const step = mode === 'drag' ? DRAG_STEP : STEP;
  // 1.5 to 4.5 s where the page keeps up
  const killedAfter = Math.round((1500 + random() * 3000) / step);
  let kill = () => {};
  const enough = new Promise((resolve) => (kill = () => resolve(undefined)));
  await page.exposeFunction(
    'soakEdit',
    (/** @type {number} */ n, /** @type {number} */ time, /** @type {number} */ ms, /** @type {number} */ inDraft) => {
      edits.push({ n, time });
      stalls.push({ time, ms });
      stored = inDraft;
      // on a machine that is slow to store, edits go on until a draft holds some
      if (edits.length >= killedAfter && (stored > 0 || edits.length > 2000)) kill();
    },
  );
  if (mode === 'slow') await slowWrites(page);
  await page.evaluate(edit, { mode, step });
  await enough;
  const crashed = new Promise((resolve) => page.once('crash', resolve));
  const cdp = await context.newCDPSession(page);
  const killedAt = Date.now();
  // never answered, since the page that would answer is gone
  void cdp.send('Page.crash').catch(() => {});
  await crashed;
  await page.close().catch(() => {});
  for (const { time, ms } of stalls) if (time > killedAt - 3000) stallMs = Math.max(stallMs, ms);
  const last = edits.filter(({ time }) => time <= killedAt);
  const next = await openEditor(context, url);
  const dialog = next.getByRole('dialog');
  const offered = await dialog.waitFor({ timeout: 20_000 }).then(
    () => true,
    () => false,
  );
  let kept = 0;
  if (offered) {
    await dialog.getByRole('button', { name: 'Recover' }).first().click();
    await next.waitForFunction(() => /** @type {any} */ (window).editor.commands.isDirty);
    kept = await next.evaluate(() => {
      const { scene } = /** @type {any} */ (window).editor.document;
      return Math.max(
        0,
        ...scene.roots.map((/** @type {{ name: string }} */ root) => Number(/^edit (\d+)$/.exec(root.name)?.[1] ?? 0)),
      );
    });
  }
  // ends as if the document was saved, so that the next killed tab's drafts are the only ones offered
  await next.evaluate(async () => {
    const { autosave, commands } = /** @type {any} */ (window).editor;
    commands.markSaved();
    for (const { id } of await autosave.store.send({ kind: 'list' })) await autosave.store.delete(id);
  });
  await next.close({ runBeforeUnload: false });
  const gone = last.filter(({ n }) => n > kept);
  return {
    mode,
    offered,
    edits: last.length,
    ...{ stored, kept },
    lost: gone.length,
    lostMs: gone.length > 0 ? killedAt - gone[0].time : 0,
    stallMs,
  };
}

/** @param {BrowserContext} context @param {string} url */
async function openEditor(context, url) {
  const page = await context.newPage();
  await page.goto(`${url}?scene=empty`);
  await page.waitForFunction(() => Boolean(/** @type {any} */ (window).editor?.autosave));
  await page.evaluate(() => /** @type {any} */ (window).editor.ready);
  return page;
}

/** A disk on which each write takes a while. @param {Page} page */
async function slowWrites(page) {
  const [worker] = page.workers();
  await worker.evaluate(() => {
    const { put } = IDBObjectStore.prototype;
    /** @this {IDBObjectStore} @param {any[]} args */
    const slowPut = function (...args) {
      for (const end = performance.now() + 40; performance.now() < end;);
      return put.apply(this, /** @type {any} */ (args));
    };
    IDBObjectStore.prototype.put = slowPut;
  });
}

/** Edits on and on, in the page; each edit is told to the test with its time. @param {{ mode: string, step: number }} options */
function edit({ mode, step: pause }) {
  const page = /** @type {any} */ (window);
  const { autosave, commands, document } = page.editor;
  let n = 0;
  // `stored` is told of a draft later than it began: edits made by one `stored` are surely in the next draft
  let [stored, atDraft] = [0, 0];
  autosave.stored.subscribe(() => ([stored, atDraft] = [atDraft, n]));
  let last = performance.now();
  /** @param {() => void} act */
  const command = (act) => ({ label: `Edit ${n}`, isEmpty: false, do: act, undo: () => {} });
  const gesture = mode === 'drag' ? commands.begin() : null;
  const step = () => {
    const now = performance.now();
    const gap = now - last;
    last = now;
    n++;
    const act = () => {
      const { scene } = document;
      if (mode === 'objects' && n % 3 === 0) {
        const first = scene.roots[0];
        scene.remove(first);
        scene.add(first);
      }
      document.scene.roots[0].name = `edit ${n}`;
    };
    if (gesture) gesture.preview(command(act));
    else commands.run(command(act));
    page.soakEdit(n, Date.now(), gap, stored);
    setTimeout(step, pause);
  };
  step();
}
