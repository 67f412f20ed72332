/**
 * `npm run build`: types and bundles of the packages, then the apps on top of them; the size of the renderer is held.
 * With `--tests`, the browser tests' own pages too, and the Stanford dragon, which is else left out of what is built: see
 * `stanfordDragon.mjs`.
 */
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { bundleSize, editorLimit, rendererLimit } from './bundleSize.mjs';
import { bundleTypes } from './bundleTypes.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { publishedPackages } from './publishedPackages.mjs';
import { root } from './root.mjs';
import { runTool } from './runTool.mjs';

ensureInstalled();
const packages = publishedPackages();
const folders = [...packages.map(({ folder }) => folder), 'apps/viewer', 'apps/editor', 'apps/lab'];
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

const bytes = bundleSize(join(root, 'packages/renderer/dist'));
console.log(`@farol/renderer: ${(bytes / 1000).toFixed(1)} kB of ${rendererLimit / 1000} kB, minified and gzipped`);
if (bytes > rendererLimit) {
  console.error('@farol/renderer is too large: see what grew, or leave something out. The limit is in bundleSize.mjs.');
  process.exit(1);
}

const editor = join(root, 'apps/editor/dist');
const [, entry] =
  /<script type="module"[^>]* src="\.\/([^"]+)"/.exec(readFileSync(join(editor, 'index.html'), 'utf8')) ?? [];
if (!entry) throw new Error('apps/editor/dist/index.html names no script: see what Vite made of it.');
const script = bundleSize(editor, entry);
console.log(
  `editor: ${(script / 1000).toFixed(1)} kB of ${editorLimit / 1000} kB before the first frame, minified and gzipped`,
);
if (script > editorLimit) {
  console.error('The editor loads too much at once: import() what the first frame does not need.');
  process.exit(1);
}
