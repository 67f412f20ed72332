import { cpSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { isWhole } from '@farol/tools/extent';
import { serveFolder } from '@farol/tools/benchServe';
import { build } from 'vite';
import { expect, test } from '../support/test';
import { linkPeers } from './linkPeers';
import { readSamples } from './samples';

/** Signs of code that draws frames by itself. */
const DRAWS = /setAnimationLoop|app\.start\(\)/;

/** A script that shows a sample's component, `Page`. */
const showing = (i: number): string => `import { createElement } from 'react';
  import { createRoot } from 'react-dom/client';
  createRoot(document.querySelector('div')).render(createElement((await import('./${i}')).Page));
  run(async () => ({}), true);`;

// the first is the quick start
const samples = readSamples().slice(0, isWhole ? undefined : 1);

test('samples of READMEs and docs run as they stand, built beside the libraries that they name', async ({
  page,
  watch,
}) => {
  const root = join(linkPeers(), 'samples');
  mkdirSync(join(root, 'host'), { recursive: true });
  for (const file of ['samplePage.ts', 'host/litScene.ts'])
    cpSync(fileURLToPath(new URL(file, import.meta.url)), join(root, file));
  for (const [i, { code, language }] of samples.entries()) {
    writeFileSync(join(root, `${i}.${language}`), `${code}\nexport {};\n`);
    const draws = !/^export /m.test(code) && DRAWS.test(code);
    const script = language === 'ts' ? `run(() => import('./${i}'), ${draws});` : showing(i);
    writeFileSync(
      join(root, `${i}.html`),
      `<!doctype html><link rel="icon" href="data:," /><canvas></canvas><div style="width: 160px; height: 120px"></div>
      <script type="module">import { run } from './samplePage'; ${script}</script>`,
    );
  }
  await build({
    ...{ root, configFile: false, logLevel: 'error', publicDir: false },
    resolve: { preserveSymlinks: true },
    oxc: { jsx: { runtime: 'automatic' } },
    build: {
      target: 'esnext',
      rolldownOptions: {
        input: Object.fromEntries(samples.map((_sample, i) => [`page${i}`, join(root, `${i}.html`)])),
      },
    },
  });
  const server = await serveFolder(join(root, 'dist'), { isolated: false });
  try {
    for (const [i, { name }] of samples.entries()) {
      await test.step(name, async () => {
        await page.goto(`${server.url}${i}.html`);
        await page.waitForFunction(() => (window as { problem?: string }).problem !== undefined);
        expect(await page.evaluate(() => (window as { problem?: string }).problem), name).toBe('');
        watch.forgive(/THREE\.Clock: This module has been deprecated/); // React Three Fiber uses THREE.Clock
        expect(watch.problems, name).toEqual([]);
      });
    }
  } finally {
    await server.close();
  }
});
