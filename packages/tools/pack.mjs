/**
 * `npm run pack`: builds the published packages and packs each into dist/, for pages that install them from this clone:
 * see "In your own page" of README.md.
 */
import { join, relative } from 'node:path';
import { ensureInstalled } from './ensureInstalled.mjs';
import { packPackages } from './packPackages.mjs';
import { root } from './root.mjs';
import { whileNobodyBuilds } from './runFolder.mjs';
import { startScript } from './startTool.mjs';

ensureInstalled();
await whileNobodyBuilds(async () => {
  if ((await startScript(join(root, 'packages/tools/build.mjs'), ['--packages'])) !== 0) process.exit(1);
  for (const tarball of packPackages(join(root, 'dist'))) console.log(relative(root, tarball));
});
