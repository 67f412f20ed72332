import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { entriesOf, type Manifest, publishedPackages } from '@farol/tools/publishedPackages';
import { expect, test } from '@playwright/test';
import { installed, readTarball } from './installed';
import { link, linkPeers } from './linkPeers';
import { reachedFrom } from './reachedFrom';
import { readSamples } from './samples';

const { host, peers, repositoryModules } = installed();
const modes = [
  { resolution: 'nodenext', module: 'nodenext' },
  { resolution: 'bundler', module: 'esnext' },
];

/** Import specifiers of all entries, apart by whether their types import a peer that the host need not have. */
function specifiers(): { alone: string[]; withPeers: string[] } {
  const found = { alone: [] as string[], withPeers: [] as string[] };
  for (const { manifest } of publishedPackages()) {
    const { files } = readTarball(manifest.name);
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

/** Samples of READMEs and docs, as modules. @param besidePeers - those that need a library besides three, or the others */
const samples = (besidePeers: boolean): string[] =>
  readSamples()
    .filter(({ code, language }) => besidePeers === (language === 'tsx' || code.includes("from 'postprocessing'")))
    .map(({ code }) => `${code}\nexport {};\n`);

/** Messages of `tsc` for sources in a folder, with every declaration file checked, or those of sources alone. */
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

/** Folders of the types of three that a host may have beside the newest: the oldest, and those that `npm run compat` gives. */
const typesOfThree = process.env.FAROL_TYPES ?? join(repositoryModules, 'three-types-oldest');

test('entries and samples compile with other types of three @verify', () => {
  const { version, dependencies } = JSON.parse(readFileSync(join(typesOfThree, 'package.json'), 'utf8')) as Manifest;
  const to = `${peers}-${version}`;
  const own = publishedPackages().map(({ manifest }) => manifest.name);
  const others = Object.keys(dependencies!).map((name) => [name, join(typesOfThree, '../..', name)] as const);
  link([...own, 'three', '@types/three'], to, { '@types/three': typesOfThree, ...Object.fromEntries(others) });
  const { alone } = specifiers();
  const output = compile(to, [...alone.map(noneIsAny), ...samples(false)], modes[1]);
  // older ones bring types of WebGPU that TypeScript's own library has by now: those that they say twice are not ours
  const ours = output.split('\n').filter((line) => /@farol[\\/]|types-bundler[\\/]\d+\.tsx/.test(line));
  expect(ours, `@types/three ${version}`).toEqual([]);
  if (!process.env.FAROL_TYPES)
    for (const { manifest } of publishedPackages())
      expect(manifest.peerDependencies!['@types/three']).toMatch(`>=${version.replace(/\d+$/, '0')} `);
});

test('samples for other libraries compile beside them', () => {
  const code = samples(true);
  expect(code.length).toBeGreaterThan(0);
  // @react-three/postprocessing has declarations that do not compile by themselves
  expect(compile(linkPeers(), code, modes[1], true)).toBe('');
});

// each by one way of resolution in the slice
for (const [i, mode] of modes.entries()) {
  const tags = ['', ' @verify'];
  test(`entries and samples compile beside three alone, moduleResolution ${mode.resolution}${tags[i]}`, () => {
    const { alone } = specifiers();
    expect(alone).toContain('@farol/renderer');
    const code = samples(false);
    expect(code.length).toBeGreaterThanOrEqual(publishedPackages().length);
    expect(compile(host, [...alone.map(noneIsAny), ...code], mode)).toBe('');
  });

  test(`entries for other libraries compile beside them, moduleResolution ${mode.resolution}${tags[1 - i]}`, () => {
    const { withPeers } = specifiers();
    expect(withPeers).toContain('@farol/renderer/r3f');
    expect(compile(linkPeers(), withPeers.map(noneIsAny), mode)).toBe('');
  });
}
