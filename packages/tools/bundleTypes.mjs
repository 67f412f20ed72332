import { basename, join } from 'node:path';
import { rollup } from 'rollup';
import { dts } from 'rollup-plugin-dts';
import { root } from './root.mjs';
import { entrySources, leftToHost, readManifest } from './publishedPackages.mjs';

/**
 * Vite plugin: writes the declarations of a package beside its bundle, one file for each of its exports and chunks for
 * what they share. Relative imports in them have extensions, so that they resolve under `nodenext` too, and what no
 * export reaches is not in them.
 *
 * @param {string} folder of the package; `tsc -b packages` must have written its declarations
 * @returns {import('vite').Plugin}
 */
export function bundleTypes(folder) {
  return {
    name: 'farol:bundle-types',
    apply: 'build',
    async closeBundle() {
      const manifest = readManifest(folder);
      const from = join(root, '.cache/types', basename(folder));
      const input = Object.keys(entrySources(manifest)).map((name) => [name, join(from, `${name}.d.ts`)]);
      const bundle = await rollup({
        input: Object.fromEntries(input),
        external: leftToHost(manifest),
        plugins: [textModules, dts()],
        onLog(_level, log) {
          // a type that no entry exports may still be used by what they export
          if (!log.message.includes('private shared type exports')) throw new Error(log.message);
        },
      });
      await bundle.write({
        dir: join(folder, 'dist'),
        entryFileNames: '[name].d.ts',
        chunkFileNames: ({ name }) => `chunks/${name.replace(/\.d$/, '')}.d.ts`,
      });
      await bundle.close();
    },
  };
}

const TEXT = 'text.d.ts';

/** Files that Vite imports as text (`?raw`): strings. @type {import('rollup').Plugin} */
const textModules = {
  name: 'farol:text-modules',
  resolveId: (source) => (source.endsWith('?raw') ? TEXT : null),
  load: (id) => (id === TEXT ? 'declare const text: string;\nexport default text;' : null),
};
