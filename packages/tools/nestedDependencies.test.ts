import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { root } from './root.mjs';

const packages = ['packages', 'apps'].flatMap((folder) =>
  readdirSync(join(root, folder)).map((name) => join(root, folder, name)),
);

/**
 * The development server makes what an app's `optimizeDeps.include` names once, of the version that the app finds: a package
 * with another version of its own would get that one, without a word.
 */
test('what the development server includes is of the version that the package which imports it has', () => {
  const wrong = packages.flatMap((app) => {
    const config = join(app, 'vite.config.ts');
    if (!existsSync(config)) return [];
    const text = /include: \[([^\]]*)\]/.exec(readFileSync(config, 'utf8'))?.[1] ?? '';
    const names = Array.from(text.matchAll(/'([^']+)'/g), ([, name]) => name);
    return names.filter((name) => packages.some((each) => existsSync(join(each, 'node_modules', name))));
  });
  expect(wrong, "write '@farol/name > dependency'").toEqual([]);
});
