import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, readdirSync, rmSync, statSync, symlinkSync } from 'node:fs';
import { join } from 'node:path';
import { publishedPackages } from './publishedPackages.mjs';
import { root } from './root.mjs';

/**
 * Builds the Lab of a checkout, and the packages that it is made of.
 *
 * @param {string} checkout - folder of the repository
 * @param {boolean} [isStageAlone] - only the page in which competitors draw, without that of the Lab's users
 * @returns {Promise<string>} folder of the built Lab
 */
export async function buildLab(checkout, isStageAlone = false) {
  const { build } = await import('vite');
  const stage = join(checkout, 'apps/lab/stage.html');
  const alone = { name: 'stage-alone', options: (/** @type {object} */ all) => ({ ...all, input: stage }) };
  for (const part of [...publishedPackages(checkout).map(({ folder }) => folder), 'apps/lab']) {
    const folder = join(checkout, part);
    const plugins = isStageAlone && part === 'apps/lab' ? [alone] : [];
    await build({ root: folder, configFile: join(folder, 'vite.config.ts'), logLevel: 'error', plugins });
  }
  return join(checkout, 'apps/lab/dist');
}

/**
 * Builds the Lab of another commit, in a temporary worktree that uses this checkout's installed packages.
 *
 * @param {string} ref
 * @param {string} to - folder to put it into; what was there goes
 * @returns {Promise<string>} `to`
 * @throws {Error} when git knows no such commit, or it has no Lab
 */
export async function buildReference(ref, to) {
  const commit = commitOf(ref);
  if (!commit)
    throw new Error(`--against ${ref}: it is neither a folder with a built Lab nor a commit that git knows.`);
  if (git('ls-tree', '--name-only', commit, 'apps/lab/package.json').trim() === '')
    throw new Error(`--against ${ref}: that commit has no Lab.`);
  if (git('diff', '--name-only', commit, '--', 'package-lock.json').trim() !== '')
    console.log(`${ref} has another package-lock.json: its Lab is built with the packages installed here.`);
  const worktree = join(root, '.cache/bench', `worktree-${process.pid}`);
  git('worktree', 'prune');
  git('worktree', 'add', '--quiet', '--detach', worktree, commit);
  try {
    linkModules(worktree);
    const dist = await buildLab(worktree, true);
    rmSync(to, { recursive: true, force: true });
    cpSync(dist, to, { recursive: true });
  } finally {
    git('worktree', 'remove', '--force', worktree);
  }
  return to;
}

/** Full name of a commit, or null when git, the repository or the commit is not there. @param {string} ref */
function commitOf(ref) {
  try {
    return git('rev-parse', '--verify', '--quiet', '--end-of-options', `${ref}^{commit}`).trim();
  } catch {
    return null;
  }
}

/** Whether a folder holds a built Lab. @param {string} folder */
export const isBuilt = (folder) => existsSync(join(folder, 'stage.html'));

/** Links the installed packages, less the repository's own, which must be the worktree's. @param {string} worktree */
function linkModules(worktree) {
  const own = '@farol';
  const from = join(root, 'node_modules');
  const to = join(worktree, 'node_modules');
  mkdirSync(join(to, own), { recursive: true });
  for (const name of readdirSync(from)) {
    // leaves out `.bin`, since a worktree runs no commands, and caches, which builds write to
    if (name !== own && !name.startsWith('.')) link(join(from, name), join(to, name));
  }
  for (const top of ['packages', 'apps']) {
    for (const name of readdirSync(join(worktree, top))) {
      const folder = join(worktree, top, name);
      if (statSync(folder).isDirectory()) link(folder, join(to, own, name));
    }
  }
}

/** @param {string} target - a folder @param {string} path */
function link(target, path) {
  if (existsSync(path)) return;
  mkdirSync(join(path, '..'), { recursive: true });
  symlinkSync(target, path, 'junction');
}

/** @param {string[]} args */
function git(...args) {
  return execFileSync('git', args, { cwd: root, encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'] });
}
