import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { packPackages, tarballName } from '@farol/tools/packPackages';
import { publishedPackages } from '@farol/tools/publishedPackages';
import { runNpm } from '@farol/tools/runNpm';
import { installed } from './installed';

/**
 * Packs the published packages and has npm install them, without a network, into a folder outside of the repository that
 * holds three and its types alone. Their place is in the environment, see `installed.ts`.
 */
export default function installPackages(): () => void {
  const folder = realpathSync(mkdtempSync(join(tmpdir(), 'farol-packages-')));
  process.env.FAROL_INSTALLED = folder;
  const { host, tarballs } = installed();
  mkdirSync(host, { recursive: true });
  packPackages(tarballs);
  const files = publishedPackages().map(({ manifest }) => join(tarballs, tarballName(manifest)));

  // without a network npm could not look anything up: what the packages depend on is given from the repository's folders, three
  // is copied, and npm says whether all are as they are asked for
  writeFileSync(join(host, 'package.json'), JSON.stringify({ name: 'host', private: true, type: 'module' }));
  const quick = ['--offline', '--legacy-peer-deps', '--ignore-scripts', '--no-audit', '--no-fund', '--install-links'];
  npm(['install', ...quick, ...files, ...foldersOfDependencies()], host);
  copyInstalled(['three', '@types/three'], host);
  const manifest = readManifest(host);
  const names = [...Object.keys(manifest.dependencies ?? {}), 'three', '@types/three'];
  const versions = names.map((name) => [name, readManifest(join(host, 'node_modules', name)).version]);
  writeFileSync(
    join(host, 'package.json'),
    JSON.stringify({ ...manifest, dependencies: Object.fromEntries(versions) }),
  );
  for (const lock of ['package-lock.json', 'node_modules/.package-lock.json'])
    rmSync(join(host, lock), { force: true });
  npm(['ls', '--all'], host);
  cpSync(new URL('host', import.meta.url), host, { recursive: true });
  return () => rmSync(folder, { recursive: true, force: true });
}

/** Folders of all that the published packages depend on besides each other, and of what that depends on. */
function foldersOfDependencies(): string[] {
  const own = new Set(publishedPackages().map(({ manifest }) => manifest.name));
  const found = new Map<string, string>();
  const visit = (names: readonly string[], within: string): void => {
    for (const name of names) {
      if (own.has(name) || found.has(name)) continue;
      const [nested, shared] = [within, installed().repositoryModules].map((folder) => join(folder, name));
      const folder = existsSync(nested) ? nested : shared;
      found.set(name, folder);
      visit(Object.keys(readManifest(folder).dependencies ?? {}), join(folder, 'node_modules'));
    }
  };
  for (const { manifest, path } of publishedPackages())
    visit(Object.keys(manifest.dependencies ?? {}), join(path, 'node_modules'));
  return [...found.values()];
}

/** Copies packages of the repository's node_modules, and what they depend on: within them where another version is there. */
function copyInstalled(names: readonly string[], to: string): void {
  const { repositoryModules } = installed();
  const optionalPeers = new Set(
    publishedPackages().flatMap(({ manifest }) => Object.keys(manifest.peerDependenciesMeta ?? {})),
  );
  const copy = (name: string, folder: string): void => {
    const from = join(repositoryModules, name);
    const { version, dependencies = {} } = readManifest(from);
    const shared = join(to, 'node_modules', name);
    const isTaken = existsSync(shared) && readManifest(shared).version !== version;
    // @types/three depends on a Rapier of its own: this host is one without that of the engine
    const isForOne = folder !== to && optionalPeers.has(name);
    const place = isTaken || isForOne ? join(folder, 'node_modules', name) : shared;
    if (existsSync(place)) return;
    cpSync(from, place, { recursive: true });
    for (const dependency of Object.keys(dependencies)) copy(dependency, place);
  };
  for (const name of names) copy(name, to);
}

function readManifest(folder: string): { version: string; dependencies?: Record<string, string> } {
  return JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
}

function npm(args: string[], cwd?: string): void {
  const { status, stdout, stderr } = runNpm(args, { ...(cwd ? { cwd } : {}), isQuiet: true });
  if (status !== 0) throw new Error(`npm ${args[0]} failed:\n${stdout}${stderr}`);
}
