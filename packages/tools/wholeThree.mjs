import { join } from 'node:path';
import { root } from './root.mjs';

/**
 * Modules that scripts are given whole, by the id that a page imports them by. A page that imported such a module's
 * namespace directly would keep all its exports in the script of its first frame.
 *
 * @type {Record<string, string>}
 */
const wholes = {
  'virtual:whole-three': 'three',
  'virtual:whole-engine': '@farol/engine',
  'virtual:whole-engine-fields': '@farol/engine/fields',
};
const sources = join(root, 'node_modules/three/src');

/** Strips GLSL of comments and blank lines, as three's own build does. @param {string} glsl */
const stripGlsl = (glsl) =>
  glsl
    .trim()
    .replace(/\r/g, '')
    .replace(/[ \t]*\/\/.*\n/g, '')
    .replace(/[ \t]*\/\*[\s\S]*?\*\//g, '')
    .replace(/\n{2,}/g, '\n');

/**
 * Vite plugin: a page is built from three's single sources, so that a part of the page which is fetched later brings
 * the code of three that it alone uses. `virtual:whole-three` is all of three, for scripts: these modules and the rest.
 *
 * @returns {import('vite').Plugin}
 */
export function wholeThree() {
  let isServed = false;
  return {
    name: 'farol-whole-three',
    enforce: 'pre',
    /** @param {{ command: string }} config */
    configResolved(config) {
      isServed = config.command === 'serve';
    },
    resolveId(source) {
      if (Object.hasOwn(wholes, source)) return `\0${source}`;
      return source === 'three' && !isServed ? join(sources, 'Three.js') : null;
    },
    load(id) {
      const whole = id.startsWith('\0') ? wholes[id.slice(1)] : undefined;
      return whole ? `export * from '${whole}';` : null;
    },
    transform(code, id) {
      if (!id.startsWith(sources) || !id.endsWith('.glsl.js')) return null;
      return code.replace(/\/\* glsl \*\/`([^]*?)`/g, (_, glsl) => JSON.stringify(stripGlsl(glsl)));
    },
  };
}
