import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { entriesOf, type Manifest, publishedPackages } from '@farol/tools/publishedPackages';
import { expect, test } from '@playwright/test';
import { installed, readTarballs } from './installed';
import { reachedFrom } from './reachedFrom';

const { host, peers, repositoryModules } = installed();
const modes = [
  { resolution: 'nodenext', module: 'nodenext' },
  { resolution: 'bundler', module: 'esnext' },
];

/** Import specifiers of all entries, apart by whether their types import a peer that the host need not have. */
function specifiers(): { alone: string[]; withPeers: string[] } {
  const found = { alone: [] as string[], withPeers: [] as string[] };
  for (const { files } of readTarballs()) {
    const manifest = JSON.parse(files.get('package.json')!) as Manifest;
    const optional = Object.keys(manifest.peerDependenciesMeta ?? {});
    for (const { name, specifier } of entriesOf(manifest)) {
      const { packages } = reachedFrom(files, [`dist/${name}.d.ts`]);
      const list = optional.some((peer) => packages.has(peer)) ? found.withPeers : found.alone;
      list.push(specifier);
    }
  }
  return found;
}

/** Fails to compile when an export of a module is `any`, as an import that TypeScript does not find would make it. */
const noneIsAny = (specifier: string): string => `import * as entry from '${specifier}';
type IsAny<T> = 0 extends 1 & T ? true : false;
type Names<M> = { [K in keyof M]: IsAny<M[K]> extends true ? K : never }[keyof M];
type None<T extends never> = T;
export type AnyOfThem = None<Names<typeof entry>>;
export const some: boolean = Object.keys(entry).length > 0;
`;

/** Blocks of code of the READMEs, as modules. @param language `ts` or `tsx` */
function examples(language: string): string[] {
  const blocks = new RegExp('```' + language + '\\n(.*?)```', 'gs');
  return readTarballs().flatMap(({ files }) =>
    [...files.get('README.md')!.matchAll(blocks)].map(([, code]) => `${code}\nexport {};\n`),
  );
}

/** What the blocks of the docs, which are parts of a page, take for given, by name. */
const given: Record<string, string> = {
  scene: "import('three').Scene",
  camera: "import('three').Camera",
  webgl: "import('three').WebGLRenderer",
  farol: "import('@farol/renderer').FarolRenderer",
  mesh: "import('three').Mesh<import('three').BufferGeometry, import('three').MeshStandardMaterial>",
  seconds: 'number',
  positionsAndRanges: 'Float32Array',
};

/** Blocks of code of the packages' docs, as modules; those of authoring.md have a test of their own. @param language `ts` or `tsx` */
function docsExamples(language: string): string[] {
  const folders = publishedPackages().map(({ path }) => join(path, 'docs'));
  const pages = folders
    .filter((folder) => existsSync(folder))
    .flatMap((folder) => readdirSync(folder).map((name) => join(folder, name)))
    .filter((path) => path.endsWith('.md') && !path.endsWith('authoring.md'));
  const blocks = new RegExp('```' + language + '\\n(.*?)```', 'gs');
  return pages.flatMap((path) =>
    [...readFileSync(path, 'utf8').matchAll(blocks)].map(([, code]) => {
      const missing = Object.keys(given).filter((name) => !new RegExp(`\\b(const|let) ${name}\\b`).test(code));
      return `${missing.map((name) => `declare const ${name}: ${given[name]};`).join('\n')}\n${code}\nexport {};\n`;
    }),
  );
}

/** What `tsc` says of sources in a folder, with every declaration file checked, or those of sources alone. */
function compile(
  folder: string,
  sources: readonly string[],
  { resolution, module }: (typeof modes)[number],
  skipLibCheck = false,
): string {
  const to = join(folder, `types-${resolution}${skipLibCheck ? '-sources' : ''}`);
  mkdirSync(to, { recursive: true });
  sources.forEach((source, i) => writeFileSync(join(to, `${i}.tsx`), source));
  const compilerOptions = {
    ...{ strict: true, noEmit: true, skipLibCheck, preserveSymlinks: true, jsx: 'react-jsx', types: [] },
    ...{ target: 'es2023', lib: ['es2023', 'dom', 'dom.iterable'], module, moduleResolution: resolution },
  };
  writeFileSync(join(to, 'tsconfig.json'), JSON.stringify({ compilerOptions, include: ['*.tsx'] }));
  const tsc = join(repositoryModules, 'typescript/bin/tsc');
  const { stdout, stderr, status } = spawnSync(process.execPath, [tsc, '-p', to], { encoding: 'utf8' });
  return status === 0 ? '' : stdout + stderr;
}

/** Links packages of the repository's node_modules and what they depend on into a folder, with those of the host first. */
function link(names: readonly string[], to: string): void {
  const all = new Set(names);
  for (const name of all) {
    const ofHost = join(host, 'node_modules', name);
    const from = existsSync(ofHost) ? ofHost : join(repositoryModules, name);
    const at = join(to, 'node_modules', name);
    mkdirSync(dirname(at), { recursive: true });
    try {
      symlinkSync(from, at, 'junction');
    } catch (error) {
      // linked before, or by a test beside this one
      if (!existsSync(at)) throw error;
    }
    const { dependencies } = JSON.parse(readFileSync(join(from, 'package.json'), 'utf8')) as Manifest;
    for (const dependency of Object.keys(dependencies ?? {})) all.add(dependency);
  }
}

/** Links the packages and all their peers beside each other. */
function linkPeers(): void {
  const own = publishedPackages().map(({ manifest }) => manifest);
  const libraries = own.flatMap(({ name, peerDependencies }) => [name, ...Object.keys(peerDependencies ?? {})]);
  link([...libraries, '@types/react'], peers);
}

test('docs for React compile beside its libraries', () => {
  linkPeers();
  const docs = docsExamples('tsx');
  expect(docs.length).toBeGreaterThan(0);
  // @react-three/postprocessing has declarations that do not compile by themselves
  expect(compile(peers, docs, modes[1], true)).toBe('');
});

// each by one way of resolution in the slice
for (const [i, mode] of modes.entries()) {
  const tags = ['', ' @verify'];
  test(`entries, READMEs and docs compile beside three alone, moduleResolution ${mode.resolution}${tags[i]}`, () => {
    const { alone } = specifiers();
    expect(alone).toContain('@farol/renderer');
    const code = examples('ts');
    expect(code.length).toBeGreaterThanOrEqual(publishedPackages().length);
    const docs = docsExamples('ts');
    expect(docs.length).toBeGreaterThan(0);
    expect(compile(host, [...alone.map(noneIsAny), ...code, ...docs], mode)).toBe('');
  });

  test(`entries for other libraries compile beside them, moduleResolution ${mode.resolution}${tags[1 - i]}`, () => {
    const { withPeers } = specifiers();
    expect(withPeers).toContain('@farol/renderer/r3f');
    linkPeers();
    const code = examples('tsx');
    expect(code.length).toBeGreaterThan(0);
    expect(compile(peers, [...withPeers.map(noneIsAny), ...code], mode)).toBe('');
  });
}
