import { existsSync, mkdirSync, readFileSync, symlinkSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { type Manifest, publishedPackages } from '@farol/tools/publishedPackages';
import { installed } from './installed';

const { host, peers, repositoryModules } = installed();

/**
 * Links packages of the repository's node_modules and what they depend on into a folder, with those of the host first.
 * @param others - folders of packages that are not there by their name
 */
export function link(names: readonly string[], to: string, others: Readonly<Record<string, string>> = {}): void {
  const all = new Set(names);
  for (const name of all) {
    const places = [join(host, 'node_modules', name), join(repositoryModules, name)];
    if (name in others) places.unshift(others[name]);
    const from = places.find((place) => existsSync(join(place, 'package.json')))!;
    const at = join(to, 'node_modules', name);
    mkdirSync(dirname(at), { recursive: true });
    try {
      symlinkSync(from, at, 'junction');
    } catch (error) {
      // linked before, or by a test beside this one
      if (!existsSync(at)) throw error;
    }
    const { dependencies } = JSON.parse(readFileSync(join(from, 'package.json'), 'utf8')) as Manifest;
    for (const dependency of Object.keys(dependencies ?? {})) {
      // one of another version than the root's lies within the package
      if (!existsSync(join(from, 'node_modules', dependency))) all.add(dependency);
    }
  }
}

/** Links the packages and all their peers beside each other, with react-dom. @returns their folder */
export function linkPeers(): string {
  const own = publishedPackages().map(({ manifest }) => manifest);
  const libraries = own.flatMap(({ name, peerDependencies }) => [name, ...Object.keys(peerDependencies ?? {})]);
  link([...libraries, '@types/react', 'react-dom'], peers);
  return peers;
}
