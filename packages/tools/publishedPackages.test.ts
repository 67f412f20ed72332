import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { leftToHost, publishedPackages } from './publishedPackages.mjs';
import { root } from './root.mjs';

const packages = publishedPackages();
const read = (...path: string[]): string => readFileSync(join(...path), 'utf8');

it('finds the packages that are not private', () => {
  const names = packages.map(({ manifest }) => manifest.name);
  expect(names).toEqual(
    expect.arrayContaining(['@farol/attach', '@farol/bake', '@farol/editing', '@farol/engine', '@farol/renderer']),
  );
  expect(names).not.toContain('@farol/tools');
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

describe.each(packages)('$manifest.name', ({ path, folder, manifest }) => {
  it('says in package.json what it is, where it comes from and whom to ask', () => {
    const home = 'https://github.com/farol-renderer/farol';
    expect(manifest).toMatchObject({
      version: JSON.parse(read(root, 'package.json')).version,
      license: 'MIT',
      author: 'The Farol authors',
      type: 'module',
      // the built-in components register themselves
      sideEffects: folder === 'packages/engine' ? ['./src/components/index.ts', './dist/components/index.js'] : false,
      homepage: `${home}/tree/main/${folder}#readme`,
      repository: { type: 'git', url: `git+${home}.git`, directory: folder },
      bugs: { url: `${home}/issues` },
      keywords: expect.arrayContaining(['three', 'threejs', 'webgl']),
      files: ['dist', 'CHANGELOG.md'],
      // a package with a scope is else published for its owners alone
      publishConfig: { access: 'public' },
    });
  });

  it('has each entry as its source, types and script, under one name', () => {
    for (const [entry, paths] of Object.entries(manifest.exports)) {
      expect(Object.keys(paths), entry).toEqual(['farol-source', 'types', 'default']);
      const name = paths.default.replace(/^\.\/dist\/|\.js$/g, '');
      expect(paths.types, entry).toBe(`./dist/${name}.d.ts`);
      expect(paths['farol-source'].replace(/x$/, ''), entry).toBe(`./src/${name}.ts`);
      expect(existsSync(join(path, paths['farol-source'])), entry).toBe(true);
    }
  });

  it('asks for the same three as the renderer, and for its types if the host uses TypeScript', () => {
    const renderer = packages.find((each) => each.manifest.name === '@farol/renderer')?.manifest;
    const { three } = renderer?.peerDependencies ?? {};
    expect(three).toBeTruthy();
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

  it("has the repository's licence and a changelog of its version", () => {
    expect(read(path, 'LICENSE')).toBe(read(root, 'LICENSE'));
    expect(read(path, 'CHANGELOG.md')).toContain(`## [${manifest.version}]`);
  });

  it('has a README that stands alone: name, install, code, every entry, and links that lead somewhere from a registry', () => {
    const text = read(path, 'README.md');
    expect(text).toMatch(new RegExp(`^# ${manifest.name}\n`));
    expect(text).toContain(`npm install ${manifest.name}`);
    expect(text).toContain('```ts\n');
    for (const entry of Object.keys(manifest.exports)) {
      expect(text).toContain(`\`${manifest.name}${entry.slice(1)}\``);
    }
    for (const [, target] of text.matchAll(/\]\(([^)]+)\)/g)) expect(target).toMatch(/^https:\/\/|^#/);
    for (const [, path] of text.matchAll(/\]\(https:\/\/github\.com\/farol-renderer\/farol\/blob\/main\/([^)#]+)/g)) {
      expect(existsSync(join(root, path)), path).toBe(true);
    }
  });
});
