import { readFile } from 'node:fs/promises';

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
      renderer ??= createMarkdownRenderer(path);
      const code = await readFile(path, 'utf8');
      const html = (await renderer).render(`\`\`\`\`${path.split('.').at(-1)}\n${code}\`\`\`\`\n`);
      return `export default ${JSON.stringify(html.replace(/<button[^>]*><\/button>/, ''))}`;
    },
  };
}
