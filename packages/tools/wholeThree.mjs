import { join } from 'node:path';
import { root } from './root.mjs';

const ID = 'virtual:whole-three';
const sources = join(root, 'node_modules/three/src');

/** As three's own build strips its shaders. @param {string} glsl */
const stripGlsl = (glsl) =>
  glsl
    .trim()
    .replace(/\r/g, '')
    .replace(/[ \t]*\/\/.*\n/g, '')
    .replace(/[ \t]*\/\*[\s\S]*?\*\//g, '')
    .replace(/\n{2,}/g, '\n');

/**
 * Vite plugin: a page is built from three's sources in place of three's one file, so that what only parts of the page use that
 * are fetched later comes with those parts. `virtual:whole-three` is all of three, for scripts: the same modules, and the rest.
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
      if (source === ID) return `\0${ID}`;
      return source === 'three' && !isServed ? join(sources, 'Three.js') : null;
    },
    load(id) {
      return id === `\0${ID}` ? `export * from 'three';` : null;
    },
    transform(code, id) {
      if (!id.startsWith(sources) || !id.endsWith('.glsl.js')) return null;
      return code.replace(/\/\* glsl \*\/`([^]*?)`/g, (_, glsl) => JSON.stringify(stripGlsl(glsl)));
    },
  };
}
