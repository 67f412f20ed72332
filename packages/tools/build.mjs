/**
 * `npm run build`: builds types and bundles of the packages, then the apps; fails if one is too large. With
 * `--tests`, it builds the browser tests' own pages too; with `--packages`, the published packages alone. The site
 * comes last, but with `--tests` and no `--site` its live modules alone: see e2e/README.md.
 *
 * `npm run build -- --site` builds what the site needs alone; `--to FOLDER` then copies it there, for any host of
 * static files: it works from any folder of a host, and fetches nothing from elsewhere.
 */
import { cpSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { ensureInstalled } from './ensureInstalled.mjs';
import { builtPackages } from './publishedPackages.mjs';
import { root } from './root.mjs';
import { runTool } from './runTool.mjs';

ensureInstalled();
// modules that need the packages installed just now
const { bundleSize, editorLimit, labLimit, rendererLimit, scriptSize } = await import('./bundleSize.mjs');
const { bundleTypes } = await import('./bundleTypes.mjs');
const packages = builtPackages();
const isForTests = process.argv.includes('--tests');
const isSiteAsked = process.argv.includes('--site');
const isSiteAlone = isSiteAsked && !isForTests;
const onlyPackages = process.argv.includes('--packages');
const folders = packages.map(({ folder }) => folder);
if (!isSiteAlone && !onlyPackages) folders.push('apps/viewer', 'apps/editor', 'apps/lab');
if (isForTests) folders.push('e2e/pages');

if (!isSiteAlone && runTool('typescript', 'tsc', ['-b', ...(onlyPackages ? folders : ['packages'])]) !== 0)
  process.exit(1);
const { build } = await import('vite');
for (const folder of folders) {
  await build({ root: join(root, folder), configFile: join(root, folder, 'vite.config.ts'), logLevel: 'warn' });
  console.log(`built ${folder}/dist`);
}
if (!onlyPackages) {
  const { buildLive, buildSite } = await import('./site/buildSite.mjs');
  await (isForTests && !isSiteAsked ? buildLive() : buildSite());
}
if (isSiteAlone) {
  const { to } = parseArgs({ options: { site: { type: 'boolean' }, to: { type: 'string' } } }).values;
  // npm runs scripts at the repository's root; INIT_CWD is the folder that it was called in
  if (to !== undefined)
    cpSync(join(root, 'apps/site/dist'), resolve(process.env.INIT_CWD ?? '.', to), { recursive: true });
  process.exit();
}
for (const each of packages) await bundleTypes(each);

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
