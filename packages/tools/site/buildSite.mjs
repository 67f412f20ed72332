import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../root.mjs';
import { liveFolder } from './liveServer.mjs';

/** Builds the site into `apps/site/dist`: its pages by VitePress, its live modules by Vite on top. */
export async function buildSite() {
  const { build: buildPages } = await import('vitepress');
  await buildPages(join(root, 'apps/site'));
  const configFile = join(liveFolder, 'vite.config.ts');
  if (existsSync(configFile)) {
    const { build } = await import('vite');
    await build({ root: liveFolder, configFile, logLevel: 'warn' });
  }
  console.log('built apps/site/dist');
}
