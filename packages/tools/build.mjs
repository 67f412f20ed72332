/**
 * `npm run build`: types and bundles of the packages, then the apps on top of them; the size of the renderer is held.
 * With `--tests`, the browser tests' own pages too, and the Stanford dragon, which is else left out of what is built: see
 * `stanfordDragon.mjs`. With `--packages`, the published packages alone; `--site` builds the site alone, on top of packages
 * that are built.
 */
import { join } from 'node:path';
import { ensureInstalled } from './ensureInstalled.mjs';
import { builtPackages } from './publishedPackages.mjs';
import { root } from './root.mjs';
import { runTool } from './runTool.mjs';

ensureInstalled();
// these need what was installed just now
const { bundleSize, editorLimit, labLimit, rendererLimit, scriptSize } = await import('./bundleSize.mjs');
const { bundleTypes } = await import('./bundleTypes.mjs');
const { buildLive, buildSite } = await import('./site/buildSite.mjs');
if (process.argv.includes('--site')) {
  await buildSite();
  process.exit();
}
const packages = builtPackages();
const folders = packages.map(({ folder }) => folder);
const onlyPackages = process.argv.includes('--packages');
if (!onlyPackages) folders.push('apps/viewer', 'apps/editor', 'apps/lab');
if (process.argv.includes('--tests')) {
  folders.push('e2e/pages');
  process.env.FAROL_STANFORD_DRAGON ??= '1';
}

if (runTool('typescript', 'tsc', ['-b', 'packages']) !== 0) process.exit(1);
const { build } = await import('vite');
for (const folder of folders) {
  await build({ root: join(root, folder), configFile: join(root, folder, 'vite.config.ts'), logLevel: 'warn' });
  console.log(`built ${folder}/dist`);
}
for (const each of packages) await bundleTypes(each);
// the tests of `npm test` build no site, only its live modules: see e2e/README.md
await (process.argv.includes('--tests') ? buildLive() : buildSite());

const bytes = bundleSize(join(root, 'packages/renderer/dist'));
console.log(`@farol/renderer: ${(bytes / 1000).toFixed(1)} kB of ${rendererLimit / 1000} kB, minified and gzipped`);
if (bytes > rendererLimit) {
  console.error('@farol/renderer is too large: see what grew, or leave something out. The limit is in bundleSize.mjs.');
  process.exit(1);
}

const pages = [
  {
    folder: 'apps/editor',
    limit: editorLimit,
    mend: 'The editor loads too much at once: import() what the first frame',
  },
  { folder: 'apps/lab', limit: labLimit, mend: 'The Lab loads too much at once: import() what the first view' },
];
for (const { folder, limit, mend } of onlyPackages ? [] : pages) {
  const script = scriptSize(join(root, folder, 'dist'));
  console.log(`${folder}: ${(script / 1000).toFixed(1)} kB of ${limit / 1000} kB at start, minified and gzipped`);
  if (script > limit) {
    console.error(`${mend} does not need.`);
    process.exit(1);
  }
}
