import { basename, join } from 'node:path';
import { rollup } from 'rollup';
import { dts } from 'rollup-plugin-dts';
import { entriesOf, leftToHost } from './publishedPackages.mjs';
import { root } from './root.mjs';

/**
 * Writes the declarations of a package into its dist: a file for each of its exports, and chunks for what they share.
 * Relative imports have extensions, so that they resolve under `nodenext` too. What no export reaches is left out.
 *
 * @param {import('./publishedPackages.mjs').PublishedPackage} published - `tsc -b packages` must have written its
 *   declarations, and its bundle be built already: building it empties dist
 */
export async function bundleTypes({ path, manifest }) {
  const from = join(root, '.cache/types', basename(path));
  const declared = (/** @type {string} */ source) => join(from, source.replace(/^\.\/src\/(.*)\.tsx?$/, '$1.d.ts'));
  const input = entriesOf(manifest).map(({ name, source }) => [name, declared(source)]);
  const bundle = await rollup({
    input: Object.fromEntries(input),
    external: leftToHost(manifest),
    plugins: [textModules, dts()],
    onLog(_level, { message }) {
      // this warning is expected: an exported declaration may use a type that no entry exports
      if (!message.includes('private shared type exports')) throw new Error(message);
    },
  });
  await bundle.write({
    dir: join(path, 'dist'),
    entryFileNames: '[name].d.ts',
    chunkFileNames: ({ name }) => `chunks/${name.replace(/\.d$/, '')}.d.ts`,
  });
  await bundle.close();
}

const TEXT = 'text.d.ts';

/** Files that Vite imports as text (`?raw`): strings. @type {import('rollup').Plugin} */
const textModules = {
  name: 'farol:text-modules',
  resolveId: (source) => (source.endsWith('?raw') ? TEXT : null),
  load: (id) => (id === TEXT ? 'declare const text: string;\nexport default text;' : null),
};
