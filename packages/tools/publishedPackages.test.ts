import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { builtPackages, entriesOf, leftToHost, packedPackages, publishedPackages } from './publishedPackages.mjs';
import { root } from './root.mjs';

const packages = builtPackages();
/** The built-in components register themselves, the demo scenes their meshes. */
const sideEffects: Readonly<Record<string, readonly string[]>> = {
  'packages/engine': ['./src/components/index.ts', './dist/chunks/components/index.js'],
  'packages/scenes': ['./src/meshPack.ts', './dist/chunks/meshPack.js'],
};
const read = (...path: string[]): string => readFileSync(join(...path), 'utf8');

it('finds the packages that are not private', () => {
  const names = packages.map(({ manifest }) => manifest.name);
  expect(names).toEqual(
    expect.arrayContaining([
      '@farol/attach',
      '@farol/bake',
      '@farol/editing',
      '@farol/engine',
      '@farol/mcp',
      '@farol/renderer',
      '@farol/scenes',
    ]),
  );
  expect(names).not.toContain('@farol/tools');
  // the package runs in Node: no page imports it
  const ofPages = publishedPackages().map(({ manifest }) => manifest.name);
  expect(names.filter((name) => !ofPages.includes(name))).toEqual(['@farol/mcp']);
});

it('leaves dependencies, peers and their parts to the host, and nothing else', () => {
  const external = leftToHost({
    ...{ name: 'x', version: '1.0.0', files: [], exports: {} },
    dependencies: { '@farol/renderer': '0.1.0' },
    peerDependencies: { three: '>=0.187.0' },
  });
  for (const id of ['three', 'three/addons/a.js', '@farol/renderer', '@farol/renderer/decals']) {
    expect(external(id), id).toBe(true);
  }
  for (const id of ['./three', 'three-mesh-bvh', '@farol/engine', '/somewhere/three'])
    expect(external(id), id).toBe(false);
});

it.each(packedPackages())(
  '$manifest.name has the version, licence and changelog of the repository',
  ({ path, manifest }) => {
    expect(manifest.version).toBe(JSON.parse(read(root, 'package.json')).version);
    expect(read(path, 'LICENSE')).toBe(read(root, 'LICENSE'));
    expect(read(path, 'CHANGELOG.md')).toContain(`## [${manifest.version}]`);
  },
);

describe.each(packages)('$manifest.name', ({ path, folder, manifest }) => {
  it('says in package.json what it is, where it comes from and whom to ask', () => {
    const home = 'https://github.com/farol-renderer/farol';
    expect(manifest).toMatchObject({
      version: JSON.parse(read(root, 'package.json')).version,
      license: 'MIT',
      author: 'The Farol authors',
      type: 'module',
      sideEffects: sideEffects[folder] ?? false,
      homepage: `${home}/tree/main/${folder}#readme`,
      repository: { type: 'git', url: `git+${home}.git`, directory: folder },
      bugs: { url: `${home}/issues` },
      keywords: expect.arrayContaining(['three', 'threejs', 'webgl']),
      files: ['dist', 'CHANGELOG.md'],
      // a package with a scope is else published for its owners alone
      publishConfig: { access: 'public' },
    });
  });

  it('has the types and script of each entry at its name in dist, so that import maps may end in /', () => {
    const named = Object.entries(manifest.exports).filter(([entry]) => !entry.includes('*'));
    const data = named.filter(([entry]) => entry.endsWith('.json'));
    for (const [entry, path] of data) expect(path).toBe(`./dist/${entry.slice(2)}`);
    const entries = named.filter((each) => !data.includes(each));
    for (const [entry, paths] of entries) {
      const name = entry === '.' ? 'index' : entry.slice(2);
      const conditions = paths as Record<string, string>;
      expect(Object.entries(conditions), entry).toEqual([
        ['farol-source', expect.stringMatching(/^\.\/src\/.+\.tsx?$/)],
        ['types', `./dist/${name}.d.ts`],
        ['default', `./dist/${name}.js`],
      ]);
      expect(existsSync(join(path, conditions['farol-source'])), entry).toBe(true);
    }
    expect(entriesOf(manifest).map(({ name }) => name)).toHaveLength(entries.length);
    // entries may end in .js, as the key of an import map has them; what they are made of may not be imported
    const patterns = { './*.js': { types: './dist/*.d.ts', default: './dist/*.js' }, './chunks/*': null };
    const others = Object.entries(manifest.exports).filter(([entry]) => entry.includes('*'));
    expect(Object.fromEntries(others)).toEqual(entries.length > 1 ? patterns : {});
  });

  it('asks for the same three as the renderer, and for its types if the host uses TypeScript, unless it runs in Node', () => {
    const renderer = packages.find((each) => each.manifest.name === '@farol/renderer')?.manifest;
    const { three } = renderer?.peerDependencies ?? {};
    if (folder === 'packages/mcp') return expect(manifest.peerDependencies).toBeUndefined();
    const [, from, to] = /^>=(\d+\.\d+)\.0 <0\.(\d+)\.0$/.exec(three!)!;
    for (const page of ['README.md', 'packages/renderer/docs/compatibility.md'])
      expect(read(root, page)).toContain(`${from} to 0.${Number(to) - 1}`);
    expect(manifest.peerDependencies).toMatchObject({ three, '@types/three': three });
    expect(manifest.peerDependenciesMeta?.['@types/three']).toEqual({ optional: true });
    expect(manifest.peerDependenciesMeta?.three).toBeUndefined();
  });

  it('depends on the others at the version of this repository', () => {
    for (const [name, version] of Object.entries(manifest.dependencies ?? {})) {
      const other = packages.find((each) => each.manifest.name === name);
      if (other) expect(version, name).toBe(other.manifest.version);
      else expect(name, 'a private package cannot be installed').not.toMatch(/^@farol\//);
    }
  });

  it('takes a range of versions of others, so that a host has each once', () => {
    const ranges = Object.entries({ ...manifest.dependencies, ...manifest.peerDependencies });
    const pinned = ranges.filter(
      ([name, range]) => !name.startsWith('@farol/') && !/^>=\d[\d.]* <\d[\d.]*$/.test(range),
    );
    expect(pinned).toEqual([]);
  });

  it('has a README that stands alone: name, install, code, every entry, and links that lead somewhere from a registry', () => {
    const text = read(path, 'README.md');
    expect(text).toMatch(new RegExp(`^# ${manifest.name}\n`));
    expect(text).toContain(`npm install ${manifest.name}`);
    expect(text).toContain('```ts\n');
    for (const { specifier } of entriesOf(manifest)) expect(text).toContain(`\`${specifier}\``);
    for (const [, target] of text.matchAll(/\]\(([^)]+)\)/g)) expect(target).toMatch(/^https:\/\/|^#/);
    for (const [, path] of text.matchAll(/\]\(https:\/\/github\.com\/farol-renderer\/farol\/blob\/main\/([^)#]+)/g)) {
      expect(existsSync(join(root, path)), path).toBe(true);
    }
  });
});
