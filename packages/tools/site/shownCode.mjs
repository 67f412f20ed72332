import { readFile } from 'node:fs/promises';

/** Colours of code, of enough contrast in both themes. */
export const codeThemes = /** @type {const} */ ({
  light: 'github-light-high-contrast',
  dark: 'github-dark-high-contrast',
});

/**
 * Vite plugin: an import whose address ends in `?shown` gives a file as highlighted HTML.
 *
 * @returns {import('vite').Plugin}
 */
export function shownCode() {
  /** @type {Promise<import('vitepress').MarkdownRenderer> | undefined} */
  let renderer;
  return {
    name: 'farol-shown-code',
    enforce: 'pre',
    async load(id) {
      const [path, query] = id.split('?');
      if (query !== 'shown') return null;
      const { createMarkdownRenderer } = await import('vitepress');
      renderer ??= createMarkdownRenderer(path, { theme: codeThemes });
      const code = await readFile(path, 'utf8');
      const html = (await renderer).render(`\`\`\`\`${path.split('.').at(-1)}\n${code}\`\`\`\`\n`);
      return `export default ${JSON.stringify(html.replace(/<button[^>]*><\/button>/, ''))}`;
    },
  };
}
