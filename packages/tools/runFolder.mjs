import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { setTimeout as pause } from 'node:timers/promises';
import { appFolders } from './serveApps.mjs';
import { root } from './root.mjs';

const runs = join(root, '.cache/runs');
const lock = join(root, '.cache/build.lock');
/** Folders of earlier runs that are kept, for their reports and traces. */
const KEPT = 3;

/**
 * Makes a folder for one run of the tests: reports, traces, and what it serves. Those of older runs are removed.
 *
 * @returns {string} path
 */
export function makeRunFolder() {
  mkdirSync(runs, { recursive: true });
  const old = readdirSync(runs).filter((name) => !isAlive(Number(name.split('-')[1])));
  for (const name of old.sort().slice(0, -KEPT)) rmSync(join(runs, name), { recursive: true, force: true });
  const folder = join(runs, `${new Date().toISOString().replaceAll(/[^0-9]/g, '')}-${process.pid}`);
  mkdirSync(folder);
  return folder;
}

/**
 * Copies what was built of the apps, so that a later build does not change what a run serves.
 *
 * @param {string} folder - of the run
 * @returns {string} folder to serve from, as FAROL_BUILT takes it
 * @throws {Error} when an app is not built
 */
export function copyBuilt(folder) {
  const built = join(folder, 'built');
  for (const [name, source] of Object.entries(appFolders)) {
    const dist = join(root, source, 'dist');
    // the site is built for `npm run verify` alone
    if (name === 'site' && !existsSync(join(dist, 'index.html'))) continue;
    if (!existsSync(join(dist, 'index.html')))
      throw new Error(`${source} is not built: run the stage build before, or "npm run build -- --tests".`);
    cpSync(dist, join(built, name), { recursive: true });
  }
  return built;
}

/**
 * Runs work that writes or packs the folders `dist` of this checkout, once no other process does. Processes that the work
 * starts do not wait for it.
 *
 * @template T
 * @param {() => Promise<T>} work
 * @returns {Promise<T>}
 */
export async function whileNobodyBuilds(work) {
  if (process.env.FAROL_BUILDS) return work();
  mkdirSync(join(root, '.cache'), { recursive: true });
  while (!take()) await pause(200);
  process.env.FAROL_BUILDS = '1';
  try {
    return await work();
  } finally {
    delete process.env.FAROL_BUILDS;
    rmSync(lock, { force: true });
  }
}

/** Takes the lock; one whose process is gone is no longer held. */
function take() {
  try {
    writeFileSync(lock, String(process.pid), { flag: 'wx' });
    return true;
  } catch {
    if (existsSync(lock) && !isAlive(Number(readFileSync(lock, 'utf8')))) rmSync(lock, { force: true });
    return false;
  }
}

/** @param {number} pid */
function isAlive(pid) {
  try {
    process.kill(pid, 0);
    return true;
  } catch (error) {
    return /** @type {NodeJS.ErrnoException} */ (error).code === 'EPERM';
  }
}
