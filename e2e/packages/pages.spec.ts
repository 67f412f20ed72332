import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { bundleSize, rendererLimit } from '@farol/tools/bundleSize';
import { serveFolder } from '@farol/tools/benchServe';
import { publishedPackages } from '@farol/tools/publishedPackages';
import type { Page } from '@playwright/test';
import { build, createServer, type Rolldown } from 'vite';
import { checkAgreement } from '../support/agreement';
import { compareImages, isFlat } from '../support/images';
import { expect, test } from '../support/test';
import type { HostPage } from './host/main';
import { installed } from './installed';

const { host } = installed();

/** Builds files of the host's folder as its own Vite would, without a configuration. @returns chunks that were written */
async function buildHost(input: string, outDir: string, external: string[] = []): Promise<Rolldown.OutputChunk[]> {
  const result = await build({
    ...{ root: host, configFile: false, logLevel: 'error', publicDir: false },
    build: {
      outDir,
      rolldownOptions: {
        ...{ input: join(host, input), external, preserveEntrySignatures: 'strict' },
        output: { entryFileNames: 'index.js' },
      },
    },
  });
  const outputs = Array.isArray(result) ? result : [result];
  return outputs
    .flatMap((each) => ('output' in each ? each.output : []))
    .filter((output): output is Rolldown.OutputChunk => output.type === 'chunk');
}

/** Chunks that an entry imports at start, itself among them. */
function loadedAtStart(chunks: readonly Rolldown.OutputChunk[], entry: string): Rolldown.OutputChunk[] {
  const names = new Set([entry]);
  const find = (name: string) => chunks.filter(({ fileName }) => fileName === name);
  for (const name of names) for (const { imports } of find(name)) for (const each of imports) names.add(each);
  return [...names].flatMap(find);
}

/** Files of a package that are in chunks, by their paths in the package. */
function filesOf(name: string, chunks: readonly Rolldown.OutputChunk[]): string[] {
  const folder = `${join(host, 'node_modules', name)}/`.replaceAll('\\', '/');
  return chunks.flatMap(({ modules }) =>
    Object.entries(modules)
      .filter(([id, { renderedLength }]) => id.startsWith(folder) && renderedLength > 0)
      .map(([id]) => id.slice(folder.length)),
  );
}

/** Sources in src/effects/ that files of the renderer were made of. */
function effectsIn(files: readonly string[]): string[] {
  return files.flatMap((file) => {
    const map = join(host, 'node_modules/@farol/renderer', `${file}.map`);
    if (!existsSync(map)) return [];
    const { sources } = JSON.parse(readFileSync(map, 'utf8')) as { sources: string[] };
    // the table of effects fetches each of their classes
    return sources.filter((source) => /\/src\/effects\/(?!index\.ts$)/.test(source));
  });
}

/** GPUs weigh the texels of a shadow map in steps of 1/256: 3.05e-4 measured on an H100, at the shadow's edge. */
const shadowRounding = process.env.FAROL_GPU ? { largest: 5e-4 } : {};

async function checkPage(page: Page, url: string): Promise<void> {
  await page.goto(url);
  await page.waitForFunction(() => 'page' in window);
  const call = <T>(ask: (host: HostPage) => T) => page.evaluate(`(${ask})(window.page)`) as Promise<Awaited<T>>;
  const stock = await call((host) => host.stock());
  expect(isFlat(stock), 'the picture shows nothing').toBe(false);
  // one that runs three's own shader, one with a G-buffer, and one that is fetched on demand
  const clustered = compareImages(stock, await call((h) => h.byFarol('clustered-forward')));
  checkAgreement('clustered-forward', clustered, 'host', shadowRounding);
  checkAgreement('deferred', compareImages(stock, await call((h) => h.byFarol('deferred'))), 'host');
  checkAgreement('light-prepass', compareImages(stock, await call((h) => h.byFarol('light-prepass'))), 'host');
  const engine = await call((host) => host.byEngine());
  expect(engine).toEqual({ drawCalls: expect.any(Number), isOneRenderer: true });
  expect(engine.drawCalls).toBeGreaterThan(0);
  expect(await call((host) => host.byScenes())).toBeGreaterThan(20);
  const [physics, scripts] = await call((host) => host.byMissing());
  expect(physics).toMatch(/Physics needs the package @dimforge\/rapier3d-compat, .*npm install/);
  expect(scripts).toMatch(/Scripts need the package sucrase, .*npm install/);
  const baked = await call((host) => host.byBake());
  expect(baked.corners).toBe(4);
  // right below the lamp, 1 m away
  expect(Math.abs(baked.brightest - 3)).toBeLessThan(0.2);
  const editor = await call((host) => host.byEditor());
  expect(editor).toEqual({ panels: 1, isOneRenderer: true, technique: 'deferred', left: 0 });
}

test('a page that Vite builds draws as stock three does, with one copy of the renderer', async ({ page }) => {
  const chunks = await buildHost('index.html', 'dist');
  for (const { manifest } of publishedPackages()) {
    const files = filesOf(manifest.name, chunks);
    expect(files.length, manifest.name).toBeGreaterThan(0);
    expect(new Set(files).size, `files of ${manifest.name} that are in two chunks`).toBe(files.length);
  }
  for (const id of chunks.flatMap(({ moduleIds }) => moduleIds)) {
    if (/[\\/](@farol|packages)[\\/]/.test(id.replace(host, ''))) expect(id).toContain(join(host, 'node_modules'));
  }
  const script = readFileSync(join(host, 'dist/index.html'), 'utf8').match(/src="\/([^"]+)"/)![1];
  expect(effectsIn(filesOf('@farol/renderer', loadedAtStart(chunks, script)))).toEqual([]);
  const server = await serveFolder(join(host, 'dist'), { isolated: false });
  try {
    await checkPage(page, server.url);
  } finally {
    await server.close();
  }
});

test("a page that Vite's development server serves draws as stock three does @verify", async ({ page }) => {
  const server = await createServer({
    ...{ root: host, configFile: false, logLevel: 'error', clearScreen: false },
    server: { host: '127.0.0.1', port: 0, hmr: false, watch: null },
  });
  try {
    await server.listen();
    await checkPage(page, server.resolvedUrls!.local[0]);
  } finally {
    await server.close();
  }
});

test('FarolRenderer alone costs what the core may weigh, and brings no effect', async () => {
  const chunks = await buildHost('bare.ts', 'dist-bare', ['three']);
  const size = bundleSize(join(host, 'dist-bare'));
  console.log(
    `import { FarolRenderer }: ${(size / 1000).toFixed(1)} kB of ${rendererLimit / 1000} kB, minified and gzipped`,
  );
  expect(size).toBeGreaterThan(rendererLimit / 2);
  expect(size).toBeLessThanOrEqual(rendererLimit);
  const files = filesOf('@farol/renderer', chunks);
  expect(files).toContain('dist/chunks/core.js');
  expect(effectsIn(filesOf('@farol/renderer', loadedAtStart(chunks, 'index.js')))).toEqual([]);
});
