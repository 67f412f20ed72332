import { cpSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../root.mjs';
import { liveFolder } from './liveServer.mjs';

/** Builds the live modules, into `apps/site/live/dist`. */
export async function buildLive() {
  const { build } = await import('vite');
  await build({ root: liveFolder, configFile: join(liveFolder, 'vite.config.ts'), logLevel: 'warn' });
  console.log('built apps/site/live/dist');
}

/** Builds the site into `apps/site/dist`: its live modules, whose sizes its pages tell, and its pages by VitePress. */
export async function buildSite() {
  await buildLive();
  const { build: buildPages } = await import('vitepress');
  await buildPages(join(root, 'apps/site'));
  cpSync(join(liveFolder, 'dist'), join(root, 'apps/site/dist/live'), { recursive: true });
  console.log('built apps/site/dist');
}
