/**
 * `npm run soak -- --minutes 30`: chaos in the browser, seeded. Most of the time a renderer goes through lost contexts,
 * exceptions, switches of everything (e2e/pages/soak); after each round its picture must be a fresh renderer's, and heap and
 * GPU objects go back. Then tabs of the editor are killed while edits go on. `npm run soak -- --help` lists the options.
 */
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { gpuFlags, softwareFlags } from './browserFlags.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { serveApps } from './serveApps.mjs';
import { killModes, killTab, MOST_LOST } from './soakKills.mjs';
import { figure, growthOf } from './soakReport.mjs';
import { soakFaults, soakRounds } from './soakRounds.mjs';

const help = `npm run soak -- [options]
  --minutes N      how long renderers are tried (default 5; 0 for none)
  --kills N        tabs of the editor that are killed (default 10)
  --seed N         another run (default 1)
  --without a,b    kinds of acts to leave out: loss, exception, technique, view, effects, scene, size, shadows, cascades,
                   lights, layers, camera, texture
  --gpu            on the GPU (default: the software rasteriser)
  --built          of what npm run build made (default: from source)`;

/** Rounds from one measurement to the next. */
const EVERY = 10;

const { values } = parseArgs({
  options: {
    minutes: { type: 'string', default: '5' },
    kills: { type: 'string', default: '10' },
    seed: { type: 'string', default: '1' },
    without: { type: 'string', default: '' },
    gpu: { type: 'boolean', default: Boolean(process.env.FAROL_GPU) },
    built: { type: 'boolean', default: false },
    help: { type: 'boolean', default: false },
  },
});
if (values.help) console.log(help);
else process.exitCode = (await soak()) === 0 ? 0 : 1;

/** @returns {Promise<number>} how many faults there are */
async function soak() {
  ensureInstalled();
  const { chromium } = await import('playwright-core');
  const { urls, close } = await serveApps({ ports: { editor: 0, pages: 0 }, built: values.built, watch: false });
  const folder = mkdtempSync(join(tmpdir(), 'farol-soak-'));
  const context = await chromium.launchPersistentContext(folder, {
    executablePath: ensureBrowser(),
    args: [...(values.gpu ? gpuFlags : softwareFlags)],
    viewport: { width: 900, height: 560 },
  });
  const seed = Number(values.seed);
  try {
    const faults = await soakRenderer(context, urls.pages ?? '', seed);
    return faults + (await soakEditor(context, urls.editor ?? '', seed));
  } finally {
    await context.close();
    await close();
    rmSync(folder, { recursive: true, force: true });
  }
}

/** @param {import('./soakReport.mjs').Sample} sample */
function sampleText({ minutes, heap, objects }) {
  return `${minutes.toFixed(1)} ${heap.toFixed(0)} ${objects}`;
}

/** @param {import('playwright-core').BrowserContext} context @param {string} url @param {number} seed */
async function soakRenderer(context, url, seed) {
  const minutes = Number(values.minutes);
  if (!(minutes > 0)) return 0;
  const end = performance.now() + minutes * 60_000;
  const page = await context.newPage();
  const without = values.without.split(',').filter(Boolean);
  const options = { url, seed, without, every: EVERY, isOver: () => performance.now() > end, say: console.log };
  const result = await soakRounds(page, options);
  await page.close();
  const { heap, objects } = growthOf(result.samples);
  console.log(`
| rounds | pictures that differ | messages | heap, kB a minute | GPU objects a minute | GPU objects at rest |
|---|---|---|---|---|---|
| ${result.rounds} | ${result.mismatches.length} | ${result.messages.length} | ${figure(heap)} | ${figure(objects)} | ${result.samples.at(-1)?.objects ?? 0} |
at rest: ${JSON.stringify(result.table)}
left once all is disposed: ${JSON.stringify(result.left)}
minutes, heap in kB and GPU objects each ${EVERY} rounds: ${result.samples.map(sampleText).join('; ')}`);
  const faults = soakFaults(result);
  for (const fault of faults.slice(-20)) console.log(fault);
  return faults.length;
}

/** @param {import('playwright-core').BrowserContext} context @param {string} url @param {number} seed */
async function soakEditor(context, url, seed) {
  let state = seed * 7919 + 1;
  const random = () => (state = (state * 48_271) % 2_147_483_647) / 2_147_483_647;
  let faults = 0;
  console.log(
    '\n| killed while | edits | lost | the oldest of them, ms | page stood still, ms | offered |\n|---|---|---|---|---|---|',
  );
  for (let i = 0; i < Number(values.kills); i++) {
    const mode = killModes[i % killModes.length];
    const kill = await killTab(context, { url, random, mode });
    const { edits, lost, lostMs, stallMs, offered } = kill;
    console.log(`| ${mode} | ${edits} | ${lost} | ${lostMs} | ${stallMs.toFixed(0)} | ${offered ? 'yes' : 'NO'} |`);
    if (!offered || lostMs > MOST_LOST + stallMs) faults++;
  }
  return faults;
}
