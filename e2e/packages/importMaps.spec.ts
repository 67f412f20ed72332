import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { serveFolder } from '@farol/tools/benchServe';
import { entriesOf, publishedPackages } from '@farol/tools/publishedPackages';
import { root } from '@farol/tools/root';
import { expect, test } from '../support/test';
import { installed, readTarball } from './installed';
import { importsOf, reachedFrom } from './reachedFrom';

const { host } = installed();
const packages = publishedPackages().map(({ manifest, path }) => ({ manifest, path, entries: entriesOf(manifest) }));

/** The import map of the renderer's README. */
function readmeMap(): Record<string, string> {
  const page = readFileSync(join(host, 'node_modules/@farol/renderer/README.md'), 'utf8');
  return JSON.parse(/<script type="importmap">(.*?)<\/script>/s.exec(page)![1]).imports;
}

/** The README's two lines, for each published package. */
function wholeMap(): Record<string, string> {
  const lines = Object.entries(readmeMap());
  const of = (name: string) => lines.map((line) => line.map((text) => text.replace('@farol/renderer', name)));
  return Object.fromEntries(packages.flatMap(({ manifest }) => of(manifest.name)));
}

/** Address that an import map gives an import; null for none. */
function addressOf(specifier: string, map: Readonly<Record<string, string>>): string | null {
  if (specifier in map) return map[specifier];
  const key = Object.keys(map).find((each) => each.endsWith('/') && specifier.startsWith(each));
  return key === undefined ? null : map[key] + specifier.slice(key.length);
}

for (const { manifest, entries } of packages) {
  test(`two lines of an import map lead to each entry of ${manifest.name}, and to each import of Farol in it`, () => {
    const { files } = readTarball(manifest.name);
    const map = wholeMap();
    for (const { specifier } of entries) {
      const asked = specifier === manifest.name ? specifier : `${specifier}.js`;
      const address = addressOf(asked, map)?.replace(`./node_modules/${manifest.name}/`, '');
      expect(files.has(address ?? ''), `${asked} at ${address}`).toBe(true);
    }
    for (const [path, source] of files) {
      if (!path.endsWith('.js')) continue;
      for (const specifier of importsOf(path, source).filter((each) => each.startsWith('@farol/'))) {
        const name = packages.find((each) => specifier.startsWith(each.manifest.name))!.manifest.name;
        const address = addressOf(specifier, map)!.replace(`./node_modules/${name}/`, '');
        expect(readTarball(name).files.has(address), `${path} imports ${specifier}`).toBe(true);
      }
    }
  });
}

test('a page with an import map runs every entry, unbundled', async ({ page }) => {
  // of the libraries that a host need not have, what is CommonJS cannot be imported by a page
  const map = { ...wholeMap(), 'three-mesh-bvh': './node_modules/three-mesh-bvh/build/index.module.js' };
  const asked = packages.flatMap(({ manifest, entries }) => {
    const { files } = readTarball(manifest.name);
    const isMapped = (name: string) => addressOf(name, map) !== null || name === 'three';
    return entries
      .filter(({ name }) => [...reachedFrom(files, [`dist/${name}.js`], true).packages].every(isMapped))
      .map(({ specifier }) => (specifier === manifest.name ? specifier : `${specifier}.js`));
  });
  expect(asked.length).toBeGreaterThan(20);
  const html = `<!doctype html><link rel="icon" href="data:," /><canvas></canvas>
    <script type="importmap">${JSON.stringify({ imports: map })}</script>`;
  const server = await serveFolder(host, { isolated: false, texts: { 'importMap.html': () => html } });
  try {
    await page.goto(`${server.url}importMap.html`);
    const names = await page.evaluate(async (specifiers) => {
      const found: Record<string, number> = {};
      for (const specifier of specifiers) found[specifier] = Object.keys(await import(specifier)).length;
      return found;
    }, asked);
    for (const specifier of asked) expect(names[specifier], specifier).toBeGreaterThan(0);
  } finally {
    await server.close();
  }
});

test('the HTML file of the start page draws lit frames', async ({ page }) => {
  const start = readFileSync(join(root, 'packages/renderer/docs/start.md'), 'utf8');
  const html = /```html\n(.*?)```/s.exec(start)![1].replace('<!doctype html>', '$&<link rel="icon" href="data:," />');
  const server = await serveFolder(host, { isolated: false, texts: { 'start.html': () => html } });
  try {
    await page.goto(`${server.url}start.html`);
    // a picture of one colour has under 3 kB; the software rasteriser takes its time
    await expect.poll(async () => (await page.screenshot()).length, { timeout: 60_000 }).toBeGreaterThan(10_000);
  } finally {
    await server.close();
  }
});
