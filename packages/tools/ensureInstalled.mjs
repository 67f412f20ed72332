import { accessSync, constants, statSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';
import { runNpm } from './runNpm.mjs';

/** Folders that installing, building and serving write to. */
const WRITTEN = ['.', 'node_modules', '.cache', 'apps/editor', 'apps/editor/node_modules'];

/** Runs `npm ci` when node_modules is missing or older than the lock file. Exits when it fails, or Farol cannot run here. */
export function ensureInstalled() {
  const problem = placeProblem(process.versions.node, root, isWritable);
  if (problem !== null) {
    console.error(problem);
    process.exit(1);
  }
  if (!needsInstall(modified('node_modules/.package-lock.json'), modified('package-lock.json'))) return;
  console.log('Installing dependencies (npm ci).');
  const done = runNpm(['ci']);
  if (done.status !== 0) {
    console.error('npm ci failed: see its message above; the network and the version of Node are the usual causes.');
    process.exit(1);
  }
}

/**
 * Why Farol cannot be installed, built or served, in one sentence with the mend; null when it can.
 *
 * @param {string} version - of Node
 * @param {string} folder - of the repository
 * @param {(path: string) => boolean} mayWrite - whether a folder can be written to, or is not there yet
 */
export function placeProblem(version, folder, mayWrite) {
  const [major, minor] = version.split('.').map(Number);
  // Vite supports no Node from 21 to 22.11
  if (!(major > 22 || (major === 22 && minor >= 12) || (major === 20 && minor >= 19)))
    return `Farol needs Node 20.19 or later of 20, or 22.12 or later, and this is Node ${version}: install a newer one.`;
  const [character] = /[#?*]/.exec(folder) ?? [];
  if (character)
    return `Farol lies in ${folder}, and Vite, which serves it, reads no path with a '${character}' in it: rename or move the folder.`;
  const closed = WRITTEN.map((each) => join(folder, each)).find((each) => !mayWrite(each));
  if (closed !== undefined)
    return `Farol cannot write to ${closed}, where it keeps what it installs and builds: allow it, or copy Farol to a folder of your own.`;
  return null;
}

/** @param {string} path */
function isWritable(path) {
  try {
    accessSync(path, constants.W_OK);
    return true;
  } catch (error) {
    return /** @type {NodeJS.ErrnoException} */ (error).code === 'ENOENT';
  }
}

/**
 * @param {number | null} installedAt - ms; when node_modules was filled, null if never
 * @param {number | null} lockedAt - ms; when the lock file was written
 */
export function needsInstall(installedAt, lockedAt) {
  return installedAt === null || (lockedAt !== null && lockedAt > installedAt);
}

/** @param {string} path */
function modified(path) {
  return statSync(join(root, path), { throwIfNoEntry: false })?.mtimeMs ?? null;
}
