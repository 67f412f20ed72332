/**
 * Bakes the atrium (the scene `sponza`) headless, prints the seconds of each phase, compares the light with a bake of
 * more samples, and times a frame that shows it against one without lights. `--help` lists the options.
 *
 * A GPU host without a network needs Node, a Chromium (CHROMIUM_PATH), packages/tools, node_modules/playwright-core and
 * .cache/bake-bench: a folder without Vite uses the page that was built last.
 */
import { existsSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { serveFolder } from './benchServe.mjs';
import { gpuFlags, softwareFlags } from './browserFlags.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { root } from './root.mjs';

const help = `node packages/tools/benchBake.mjs [options]

  --size 2048         width of the lightmap (texels)
  --bounces 3
  --samples 256       of the bake that is timed
  --settings A;B      bakes several times, each with options of its own beside those above, and compares all with one
                      reference: "samples=64;samples=256,indirectScale=0.25,denoise=false"
  --reference 4096    samples of the bake that it is compared with; 0: none
  --lights 50         point lights of the atrium, beside its sun and sky
  --padding 4         texels between charts
  --slice 12          milliseconds of GPU time between two moments at which a page may draw
  --techniques a,b    that frames are timed by; default deferred,forward,stock; none for no frames
  --frame 1920x1080   size of the frames (pixels)
  --rounds 9          turns of each kind of frame
  --turn 400          of a turn (ms)
  --gpu               leave the flags of the software rasteriser out
  --built             use the page that was built last
  --json FILE         writes the figures
  --help              this text`;

const texts = ['size', 'bounces', 'samples', 'settings', 'reference', 'lights', 'slice', 'padding', 'techniques'];
const options = Object.fromEntries([
  ...[...texts, 'frame', 'rounds', 'turn', 'json'].map((name) => [name, /** @type {const} */ ({ type: 'string' })]),
  ...['gpu', 'built', 'help'].map((name) => [name, /** @type {const} */ ({ type: 'boolean' })]),
]);
const page = join(root, '.cache/bake-bench');

try {
  const values = /** @type {Record<string, string | boolean | undefined>} */ (parseArgs({ options }).values);
  if (values.help) console.log(help);
  else {
    const hasVite = existsSync(join(root, 'node_modules/vite'));
    if (!values.built && hasVite) await buildPage();
    else if (!existsSync(join(page, 'bakeBench.html'))) throw new Error(`${page} has no page: leave --built out.`);
    await measure(values);
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}

async function buildPage() {
  const { build } = await import('vite');
  const { sourceConditions } = await import('./sourceConditions.mjs');
  const folder = join(root, 'e2e/pages');
  await build({
    ...{ root: folder, configFile: false, base: './', publicDir: false, logLevel: 'warn' },
    assetsInclude: ['**/*.ply.gz'],
    resolve: { dedupe: ['three'], conditions: sourceConditions },
    worker: { format: 'es', rolldownOptions: { external: [/^node:/] } },
    build: {
      ...{ target: 'es2022', outDir: page, emptyOutDir: true, chunkSizeWarningLimit: 4000 },
      rolldownOptions: { input: join(folder, 'bakeBench.html') },
    },
  });
}

/**
 * @param {string} name
 * @param {string | undefined} given
 * @param {number} usual
 * @param {number} least
 */
function number(name, given, usual, least) {
  const value = Number(given ?? usual);
  if (Number.isInteger(value) && value >= least) return value;
  throw new Error(`--${name} ${given}: a whole number of ${least} or more is needed.`);
}

/**
 * Options of each bake: those that all have in common, and its own.
 *
 * @param {string} text - "samples=64,denoise=false;samples=128"
 * @param {Record<string, unknown>} common
 * @returns {{ name: string, bake: Record<string, unknown> }[]}
 */
function readSettings(text, common) {
  return text.split(';').map((each) => {
    const own = each.split(',').map((pair) => {
      const [, key, value] = /^\s*(\w+)=([\w.]+)\s*$/.exec(pair) ?? [];
      if (key === undefined) throw new Error(`--settings ${pair}: name=value is needed, as in samples=64.`);
      const known = /** @type {Record<string, unknown>} */ ({ true: true, false: false });
      return [key, value in known ? known[value] : Number(value)];
    });
    return { name: each.trim(), bake: { ...common, ...Object.fromEntries(own) } };
  });
}

/** @param {Record<string, string | boolean | undefined>} values */
function readOptions(values) {
  const of = (/** @type {string} */ name, /** @type {number} */ usual, least = 1) =>
    number(name, /** @type {string | undefined} */ (values[name]), usual, least);
  const frame = /^(\d+)x(\d+)$/.exec(String(values.frame ?? '1920x1080'));
  if (!frame) throw new Error(`--frame ${values.frame}: width x height is needed, as in 1920x1080.`);
  const techniques = String(values.techniques ?? 'deferred,forward,stock');
  return {
    lights: of('lights', 50, 0),
    reference: of('reference', 4096, 0),
    bake: {
      ...{ size: of('size', 2048, 16), bounces: of('bounces', 3, 0) },
      ...{ samples: of('samples', 256), sliceMilliseconds: of('slice', 12), padding: of('padding', 4) },
    },
    techniques: techniques === 'none' ? [] : techniques.split(','),
    ...{ frame: { width: Number(frame[1]), height: Number(frame[2]) }, rounds: of('rounds', 9), turn: of('turn', 400) },
  };
}

/** @param {Record<string, string | boolean | undefined>} values */
async function measure(values) {
  const options = readOptions(values);
  const server = await serveFolder(page, { isolated: true });
  const args = [...(values.gpu ? gpuFlags : softwareFlags)];
  const browser = await chromium.launch({ executablePath: ensureBrowser(), args });
  try {
    const tab = await browser.newPage({ viewport: { width: 480, height: 360 } });
    tab.setDefaultTimeout(0);
    tab.on('pageerror', (error) => console.log(`page error: ${error.message}`));
    await tab.goto(`${server.url}bakeBench.html`);
    await tab.waitForFunction(() => 'BakeBench' in window);
    const device = await tab.evaluate(async (lights) => {
      const own = /** @type {any} */ (window);
      own.bakeBench = await own.BakeBench.make(lights);
      return own.bakeBench.device;
    }, options.lights);
    const { size, bounces, samples } = options.bake;
    const settings = readSettings(String(values.settings ?? `samples=${samples}`), options.bake);
    console.log(`${device}, Chromium ${browser.version()}`);
    console.log(`Atrium, ${options.lights} lights, sun and sky; ${size}², ${bounces} bounces`);
    const says = setInterval(() => void tellProgress(tab), 30_000);
    try {
      /** @type {{ name: string, baked: any, difference?: any }[]} */
      const bakes = [];
      for (const { name, bake } of settings) {
        console.log(name);
        const baked = await run(tab, 'bake', bake);
        printBake(baked);
        bakes.push({ name, baked });
      }
      if (options.reference > 0) {
        /** @type {any[]} */
        const differences = await run(tab, 'compare', reference(options));
        differences.forEach((difference, i) => {
          bakes[i].difference = difference;
          printDifference(bakes[i].name, difference, options.reference);
        });
      }
      /** @type {Record<string, any>} */
      const frames = {};
      for (const technique of options.techniques) {
        frames[technique] = await run(tab, 'frames', technique, options.frame, options.rounds, options.turn);
        printFrames(technique, frames[technique], options.frame);
      }
      if (values.json) {
        const figures = { device, browser: browser.version(), options, bakes, frames };
        writeFileSync(resolve(String(values.json)), `${JSON.stringify(figures, null, 2)}\n`);
      }
    } finally {
      clearInterval(says);
    }
  } finally {
    await browser.close();
    await server.close();
  }
}

/** Reference bake: with a seed, so with noise, of its own. @param {ReturnType<typeof readOptions>} options */
function reference({ bake, reference: samples }) {
  return { ...bake, samples, seed: 2, denoise: false, indirectScale: 1 };
}

/** @param {import('playwright-core').Page} tab @param {string} name @param {unknown[]} given @returns {Promise<any>} */
function run(tab, name, ...given) {
  return tab.evaluate(({ name, given }) => /** @type {any} */ (window).bakeBench[name](...given), { name, given });
}

/** @param {import('playwright-core').Page} tab */
async function tellProgress(tab) {
  const progress = await tab.evaluate(() => /** @type {any} */ (window).bakeBench.progress).catch(() => '');
  if (progress) console.log(`  … ${progress}`);
}

/** @param {{ seconds: Record<string, number>, covered: number, texelsPerMetre: number, lightmaps: number, bytes: number, rays: number, warnings: string[] }} figures */
function printBake({ seconds, covered, texelsPerMetre, lightmaps, bytes, rays, warnings }) {
  const names = {
    ...{ unwrap: 'unwrap', merge: 'merge triangles', bvh: 'build BVH', tables: 'fill tables', trace: 'trace' },
    ...{
      filter: 'denoise and dilate',
      read: 'read back',
      stitch: 'stitch seams',
      other: 'other',
      all: 'bake',
      encode: 'encode the file',
    },
  };
  for (const [key, name] of Object.entries(names))
    console.log(`  ${name.padEnd(20)}${(seconds[key] ?? 0).toFixed(2)} s`);
  console.log(
    `  charts cover ${(100 * covered).toFixed(1)}% of ${lightmaps} lightmap${lightmaps > 1 ? 's' : ''}, ` +
      `${texelsPerMetre.toFixed(1)} texels a metre; file ${(bytes / 1e6).toFixed(2)} MB, ${(rays / 1e6).toFixed(2)} M rays of indirect light`,
  );
  for (const warning of warnings) console.log(`  warning: ${warning}`);
}

/**
 * @param {string} name
 * @param {{ linear: number, coded: number, white: number, bias: number, texels: number }} difference
 * @param {number} samples
 */
function printDifference(name, { linear, coded, white, bias, texels }, samples) {
  console.log(
    `${name}: against ${samples} samples, ${texels} texels: ${linear.toFixed(1)} dB linear, ${coded.toFixed(1)} dB as sRGB ` +
      `(white ${white.toFixed(2)}, the 99.9th percentile), mean ${bias < 0 ? '' : '+'}${(100 * bias).toFixed(2)}%`,
  );
}

/** @param {string} technique @param {{ baked: number, unlit: number, ratio: number, lit: number }} figures @param {{ width: number, height: number }} size */
function printFrames(technique, { baked, unlit, ratio, lit }, { width, height }) {
  console.log(
    `  ${technique}, ${width} × ${height}: baked ${baked.toFixed(2)} ms, without lights ${unlit.toFixed(2)} ms ` +
      `(${ratio.toFixed(3)} ×), lights drawn ${lit.toFixed(2)} ms`,
  );
}
