/**
 * `npm run release`: versions, CHANGELOGs, all tests, tarballs, a commit and a tag, and then it stops: what is to be
 * published lies in dist/, and the commands that publish it are printed.
 */
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { ensureInstalled } from './ensureInstalled.mjs';
import { tarballName } from './packPackages.mjs';
import { packedPackages, readManifest } from './publishedPackages.mjs';
import { changelogSection, releasePlan, writeRelease } from './releaseFiles.mjs';
import { root } from './root.mjs';
import { runNpm } from './runNpm.mjs';
import { startScript } from './startTool.mjs';

const help = `npm run release [-- options]: makes the next version ready, and publishes nothing

  --dry-run   shows version, CHANGELOGs and tarballs, and changes nothing
  --help      this

Changes come from .changeset/ ("npx changeset" writes one); a version that has no tag yet is released as it is. It needs the branch main without changes that are not committed,
runs "npm run verify", and ends with a commit, the tag v<version> and the tarballs in dist/.`;

const { values } = parseArgs({
  options: { 'dry-run': { type: 'boolean', default: false }, help: { type: 'boolean', default: false } },
});
if (values.help) {
  console.log(help);
  process.exit(0);
}
ensureInstalled();
const isDry = values['dry-run'];
const date = new Date().toISOString().slice(0, 10);

const plan = releasePlan(root);
const version = plan?.version ?? readManifest(root).version;
const tag = `v${version}`;
if (git('tag', '--list', tag) !== '')
  end(`The tag ${tag} is there, and no change waits in .changeset/: "npx changeset" writes one.`);
console.log(plan ? `${plan.before} to ${version}` : `${version}, as it is`);
if (plan) {
  for (const { manifest, folder } of packedPackages())
    console.log(`\n== ${folder}/CHANGELOG.md\n${changelogSection(manifest.name, plan, date)}`);
}
if (isDry) {
  const names = packedPackages().map(({ manifest }) => tarballName({ ...manifest, version }));
  console.log(`\nTarballs: ${names.join(', ')}\nTag: ${tag}\nNothing was changed.`);
  process.exit(0);
}

if (git('branch', '--show-current') !== 'main') end('A release is made of the branch main: git switch main.');
if (git('status', '--porcelain') !== '') end('There are changes that are not committed: commit them first.');

if (plan) {
  writeRelease(root, plan, date);
  if (runNpm(['install', '--package-lock-only', '--prefer-offline']).status !== 0) end(`npm failed: ${undo()}`);
}
if ((await startScript(join(root, 'packages/tools/test.mjs'), ['--verify'])) !== 0) end(`Tests failed: ${undo()}`);
if ((await startScript(join(root, 'packages/tools/pack.mjs'), [])) !== 0) end(`Nothing was packed: ${undo()}`);
if (plan) git('commit', '--all', '--message', `Release ${version}`);
git('tag', '--annotate', tag, '--message', `Farol ${version}`);
const commands = packedPackages().map(({ manifest }) => `npm publish dist/${tarballName(manifest)}`);
console.log(
  `\nReady: commit, tag ${tag}, tarballs. To publish:\n  ${['git push --follow-tags', ...commands].join('\n  ')}`,
);

/** @param {string} problem @returns {never} */
function end(problem) {
  console.error(problem);
  process.exit(1);
}

function undo() {
  return 'see above. "git reset --hard" takes the version back.';
}

/** @param {string[]} args @returns {string} what git said */
function git(...args) {
  const { status, stdout, stderr } = spawnSync('git', args, { cwd: root, encoding: 'utf8' });
  if (status !== 0) end(`git ${args[0]} failed: ${stderr}`);
  return stdout.trim();
}
