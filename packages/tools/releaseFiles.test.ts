import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';
import { changelogSection, releasePlan, withSection, writeRelease } from './releaseFiles.mjs';
import { root } from './root.mjs';

const checkout = mkdtempSync(join(tmpdir(), 'farol-release-'));
afterAll(() => rmSync(checkout, { recursive: true, force: true }));
const read = (path: string): string => readFileSync(join(checkout, path), 'utf8');

const change = (summary: string, ...releases: [name: string, type: string][]) => ({
  ...{ summary, releases: releases.map(([name, type]) => ({ name, type })) },
});

it("writes a section of a package's own changes, gravest first, above the one before", () => {
  const changesets = [
    change('A mend.', ['@farol/engine', 'patch']),
    change('A lamp\nof two lines.', ['@farol/engine', 'minor'], ['@farol/renderer', 'patch']),
    change('Elsewhere.', ['@farol/bake', 'minor']),
  ];
  const plan = { before: '0.1.0', version: '0.2.0', changesets };
  const section = changelogSection('@farol/engine', plan, '2027-01-31');
  const text =
    '# Changelog\n\nNotable changes.\n\n## [0.1.0] - 2026-11-22\n\nThe first.\n\n[0.1.0]: https://x/v0.1.0\n';
  expect(withSection(text, section, '0.2.0')).toBe(`# Changelog

Notable changes.

## [0.2.0] - 2027-01-31

### Added

- A lamp
  of two lines.

### Fixed

- A mend.

## [0.1.0] - 2026-11-22

The first.

[0.2.0]: https://github.com/farol-renderer/farol/releases/tag/v0.2.0
[0.1.0]: https://x/v0.1.0
`);
  expect(changelogSection('@farol/attach', plan, '2027-01-31')).toMatch(/\n\nNothing but the version/);
});

it('gives all packages, what they ask of each other, templates and README one next version', () => {
  for (const path of ['package.json', 'README.md', '.changeset/config.json', '.changeset/README.md']) copy(path);
  const folders = ['packages', 'apps'].flatMap((folder) =>
    readdirSync(join(root, folder)).map((name) => `${folder}/${name}`),
  );
  for (const folder of folders) for (const name of ['package.json', 'CHANGELOG.md']) copy(`${folder}/${name}`);
  copy('packages/create-farol/templates');
  const git = (...args: string[]) => {
    const who = ['-c', 'user.name=Farol', '-c', 'user.email=farol@example.com'];
    const { status, stderr } = spawnSync('git', [...who, ...args], { cwd: checkout, encoding: 'utf8' });
    expect(status, stderr).toBe(0);
  };
  git('init', '--quiet', '--initial-branch=main');
  git('add', '--all');
  git('commit', '--quiet', '--message', 'Before');
  expect(releasePlan(checkout)).toBeNull();

  writeFileSync(join(checkout, '.changeset/a-lamp.md'), "---\n'@farol/engine': minor\n---\n\nA lamp.\n");
  const plan = releasePlan(checkout)!;
  expect(plan).toMatchObject({ before: '0.1.0', version: '0.2.0' });
  expect(JSON.parse(read('packages/engine/package.json')).version, 'a plan changes nothing').toBe('0.1.0');

  writeRelease(checkout, plan, '2027-01-31');
  const manifests = ['package.json', ...folders.map((folder) => `${folder}/package.json`)]
    .filter((path) => existsSync(join(checkout, path)))
    .map(read);
  expect(manifests.length).toBeGreaterThan(10);
  const farol = manifests.flatMap((text) =>
    [...text.matchAll(/"(?:version|@farol\/[\w-]+)": "(\d.*)"/g)].map(([, each]) => each),
  );
  expect(new Set(farol)).toEqual(new Set(['0.2.0']));
  expect(read('packages/create-farol/templates/scene/package.json')).toContain('"@farol/engine": "^0.2.0"');
  expect(read('README.md')).toContain('farol-renderer-0.2.0.tgz three');
  expect(read('packages/engine/CHANGELOG.md')).toContain(
    '## [0.2.0] - 2027-01-31\n\n### Added\n\n- A lamp.\n\n## [0.1.0]',
  );
  expect(read('packages/create-farol/CHANGELOG.md')).toContain('## [0.2.0] - 2027-01-31\n\nNothing but the version');
  expect(readdirSync(join(checkout, '.changeset')).toSorted()).toEqual(['README.md', 'config.json']);
});

function copy(path: string): void {
  if (existsSync(join(root, path))) cpSync(join(root, path), join(checkout, path), { recursive: true });
}
