import { dirname, join, normalize } from 'node:path/posix';
import { type Problem, checkPackage, createPackageFromTarballData } from '@arethetypeswrong/core';
import { builtPackages, type Manifest, entriesOf } from '@farol/tools/publishedPackages';
import { expect, test } from '@playwright/test';
import { publint } from 'publint';
import { formatMessage } from 'publint/utils';
import { readTarball } from './installed';
import { reachedFrom } from './reachedFrom';

/** Files of a package beside dist. */
const papers = ['CHANGELOG.md', 'LICENSE', 'README.md', 'package.json'];

for (const { manifest } of builtPackages()) {
  test.describe(manifest.name, () => {
    test('holds its papers and what its entries reach, nothing else', () => {
      const { files } = readTarball(manifest.name);
      const scripts = reachedFrom(files, entries(manifest, 'js')).paths;
      const types = reachedFrom(files, entries(manifest, 'd.ts')).paths;
      const maps = [...scripts].map((path) => `${path}.map`).filter((path) => files.has(path));
      const data = Object.values(manifest.exports).flatMap((path) => (typeof path === 'string' ? path.slice(2) : []));
      expect([...files.keys()].sort()).toEqual([...papers, ...scripts, ...types, ...maps, ...data].sort());
    });

    test('imports what it declares, and declares what it imports', () => {
      const { files } = readTarball(manifest.name);
      const { packages } = reachedFrom(files, [...entries(manifest, 'js'), ...entries(manifest, 'd.ts')]);
      const declared = Object.keys({ ...manifest.dependencies, ...manifest.peerDependencies });
      // types have no package of their own to import
      expect([...packages].sort()).toEqual(declared.filter((name) => !name.startsWith('@types/')).sort());
    });

    test('needs no optional peer for what its own name exports', () => {
      const { files } = readTarball(manifest.name);
      const optional = Object.keys(manifest.peerDependenciesMeta ?? {});
      const atStart = reachedFrom(files, ['dist/index.js'], true).packages;
      const inTypes = reachedFrom(files, ['dist/index.d.ts']).packages;
      expect(optional.filter((name) => atStart.has(name) || inTypes.has(name))).toEqual([]);
    });

    test('has source maps with the sources in them, all of them its own', () => {
      const { files } = readTarball(manifest.name);
      const maps = [...files.keys()].filter((path) => path.endsWith('.map'));
      expect(maps.length).toBeGreaterThan(0);
      for (const path of maps) {
        const { sources, sourcesContent } = JSON.parse(files.get(path)!) as Record<string, string[] | undefined>;
        expect(sources!.length, path).toBeGreaterThan(0);
        expect(sourcesContent?.filter(Boolean).length, path).toBe(sources!.length);
        // a source of another package would be a second copy of that package
        for (const source of sources!) expect(normalize(join(dirname(path), source)), path).toMatch(/^src\//);
      }
      // a script without a map makes nothing of its own: it passes on what others export
      for (const [path, source] of files) {
        if (!path.endsWith('.js') || files.has(`${path}.map`)) continue;
        expect(source, path).not.toContain('sourceMappingURL');
        if (!path.endsWith('runtime.js')) expect(source, path).toMatch(/^(import|export)[^;()=]+;/);
      }
    });

    test('publint finds nothing', async () => {
      const bytes = new Uint8Array(readTarball(manifest.name).bytes);
      const { messages, pkg } = await publint({ pack: { tarball: bytes.buffer }, level: 'suggestion', strict: true });
      expect(messages.map((message) => formatMessage(message, pkg, { color: false }))).toEqual([]);
    });

    test('Are the types wrong? finds nothing', async () => {
      const found = await checkPackage(createPackageFromTarballData(new Uint8Array(readTarball(manifest.name).bytes)));
      const names = found.types ? Object.keys(found.entrypoints).filter((entry) => !/\*|\.json$/.test(entry)) : [];
      expect(names).toHaveLength(entriesOf(manifest).length);
      expect('problems' in found ? found.problems.filter(isOfModules).map(said) : found).toEqual([]);
    });
  });
}

/** Files of a package's entries in the package. */
function entries(manifest: Manifest, kind: 'd.ts' | 'js'): string[] {
  return entriesOf(manifest).map(({ name }) => `dist/${name}.${kind}`);
}

/** ES modules alone, as of its profile "esm-only": what `require` and Node 10 make of them is not asked. */
function isOfModules(problem: Problem): boolean {
  return !('resolutionKind' in problem && /^node10$|^node16-cjs$/.test(problem.resolutionKind));
}

const said = (problem: Problem): string => JSON.stringify(problem);
