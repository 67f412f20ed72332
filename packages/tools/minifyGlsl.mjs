import { readFile } from 'node:fs/promises';

/**
 * Vite plugin: in a production build, `import text from './<name>.glsl?raw'` gives the text without comments and
 * indentation. Line numbers stay, so that errors name the line of the file.
 *
 * @returns {import('vite').Plugin}
 */
export function minifyGlsl() {
  return {
    name: 'farol:minify-glsl',
    apply: 'build',
    enforce: 'pre',
    async load(id) {
      if (!id.endsWith('.glsl?raw')) return null;
      const path = id.slice(0, -'?raw'.length);
      this.addWatchFile(path);
      return {
        code: `export default ${JSON.stringify(minifiedGlsl(await readFile(path, 'utf8')))};`,
        moduleType: 'js',
      };
    },
  };
}

/**
 * @param {string} text - GLSL ES 3.00
 * @returns {string} the same lines without comments, indentation, the blanks round operators and `const in`
 */
export function minifiedGlsl(text) {
  return text
    .replace(/\/\*[\s\S]*?\*\//g, (comment) => comment.replace(/[^\n]+/g, ' '))
    .replace(/\/\/(?!#).*$/gm, '')
    .split(/\r?\n/)
    .map((line) => (/^\s*(\/\/)?#/.test(line) ? line.trim() : tightened(line)))
    .join('\n')
    .trimEnd();
}

/** @param {string} line - outside of the preprocessor; the last character stays as it is for a `\` at the end of a line */
function tightened(line) {
  return (
    line
      .trim()
      .replace(/\s+/g, ' ')
      // GLSL passes `in` and `const in` parameters alike: `const` only forbids writing
      .replace(/\bconst in /g, '')
      .replace(/ ?([=+\-*/<>,;(){}?:&|!]) ?/g, (match, sign, at, whole) =>
        keepsBlank(whole, at, match) ? match : sign,
      )
  );
}

/**
 * `a + +b` and `a - -b` need their blanks.
 *
 * @param {string} whole @param {number} at @param {string} match
 */
function keepsBlank(whole, at, match) {
  return /[+-]/.test(match) && (/[+-]/.test(whole[at - 1] ?? '') || /[+-]/.test(whole[at + match.length] ?? ''));
}
