import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { packedPackages } from './publishedPackages.mjs';
import { toolPath } from './toolPath.mjs';

/** Headings of a CHANGELOG by the kinds of changes. */
const headings = { major: 'Changed: code of users has to follow', minor: 'Added', patch: 'Fixed' };

/** @typedef {keyof typeof headings} ChangeKind */

/**
 * @typedef {object} ReleasePlan
 * @property {string} before - version that is out
 * @property {string} version - version to come, of all packages
 * @property {{ summary: string, releases: { name: string, type: string }[] }[]} changesets
 */

/**
 * Runs changesets.
 *
 * @param {string} checkout
 * @param {string[]} args
 * @throws {Error} with its words
 */
function changeset(checkout, args) {
  const run = spawnSync(process.execPath, [toolPath('@changesets/cli', 'changeset'), ...args], {
    ...{ cwd: checkout, encoding: 'utf8' },
  });
  if (run.status !== 0) throw new Error(`changeset ${args[0]} failed:\n${run.stdout}${run.stderr}`);
}

/**
 * Version and changes of the next release, by the files of .changeset/.
 *
 * @param {string} checkout - folder of a repository
 * @returns {ReleasePlan | null} null where no change waits
 */
export function releasePlan(checkout) {
  const isChange = (/** @type {string} */ name) => name.endsWith('.md') && name !== 'README.md';
  if (!readdirSync(join(checkout, '.changeset')).some(isChange)) return null;
  mkdirSync(join(checkout, '.cache'), { recursive: true });
  changeset(checkout, ['status', '--output', '.cache/release.json']);
  const { changesets, releases } = JSON.parse(readFileSync(join(checkout, '.cache/release.json'), 'utf8'));
  const [{ newVersion }] = releases;
  return {
    before: JSON.parse(readFileSync(join(checkout, 'package.json'), 'utf8')).version,
    version: newVersion,
    changesets,
  };
}

/**
 * Section of a package's CHANGELOG.
 *
 * @param {string} name - of the package
 * @param {ReleasePlan} plan
 * @param {string} date - as in 2026-11-22
 */
export function changelogSection(name, { version, changesets }, date) {
  const parts = Object.entries(headings).flatMap(([kind, heading]) => {
    const own = changesets.filter(({ releases }) => releases.some((each) => each.name === name && each.type === kind));
    return own.length === 0 ? [] : [`### ${heading}\n\n${own.map(({ summary }) => item(summary)).join('\n')}`];
  });
  if (parts.length === 0) parts.push('Nothing but the version, which all packages share.');
  return [`## [${version}] - ${date}`, ...parts].join('\n\n');
}

/** @param {string} summary @returns {string} item of a list, its further lines below its first */
function item(summary) {
  return `- ${summary.trim().replaceAll('\n', '\n  ')}`;
}

/**
 * Puts a section above the one before, and its link among the links at the end.
 *
 * @param {string} changelog
 * @param {string} section
 * @param {string} version
 */
export function withSection(changelog, section, version) {
  const link = `[${version}]: https://github.com/farol-renderer/farol/releases/tag/v${version}`;
  return changelog.replace(/^## \[/m, `${section}\n\n$&`).replace(/^\[\d.*?\]: /m, `${link}\n$&`);
}

/**
 * Writes versions and CHANGELOGs of a release, and removes the files of .changeset/ that it is made of.
 *
 * @param {string} checkout
 * @param {ReleasePlan} plan
 * @param {string} date
 */
export function writeRelease(checkout, plan, date) {
  const { before, version } = plan;
  changeset(checkout, ['version']);
  for (const { path, manifest } of packedPackages(checkout))
    edit(join(path, 'CHANGELOG.md'), (text) => withSection(text, changelogSection(manifest.name, plan, date), version));
  edit(join(checkout, 'package.json'), (text) => text.replace(`"version": "${before}"`, `"version": "${version}"`));
  edit(join(checkout, 'README.md'), (text) => text.replaceAll(`-${before}.tgz`, `-${version}.tgz`));
  const templates = join(checkout, 'packages/create-farol/templates');
  for (const kind of existsSync(templates) ? readdirSync(templates) : []) {
    const path = join(templates, kind, 'package.json');
    if (existsSync(path)) edit(path, (text) => text.replaceAll(/("@farol\/[\w-]+": "\^)[^"]+/g, `$1${version}`));
  }
}

/** @param {string} path @param {(text: string) => string} change */
function edit(path, change) {
  writeFileSync(path, change(readFileSync(path, 'utf8')));
}
