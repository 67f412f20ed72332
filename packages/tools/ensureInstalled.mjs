import { statSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';
import { runNpm } from './runNpm.mjs';

/** Runs `npm ci` when node_modules is missing or older than the lock file. Exits when it fails. */
export function ensureInstalled() {
  const [major] = process.versions.node.split('.');
  if (Number(major) < 20) {
    console.error(`Farol needs Node 20 or later, and this is Node ${process.versions.node}: install a newer one.`);
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
 * @param {number | null} installedAt ms; when node_modules was filled, null if never
 * @param {number | null} lockedAt ms; when the lock file was written
 */
export function needsInstall(installedAt, lockedAt) {
  return installedAt === null || (lockedAt !== null && lockedAt > installedAt);
}

/** @param {string} path */
function modified(path) {
  return statSync(join(root, path), { throwIfNoEntry: false })?.mtimeMs ?? null;
}
