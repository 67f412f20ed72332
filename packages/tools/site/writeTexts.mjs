import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { root } from '../root.mjs';
import { pagesFolder, readPage, siteLink, sitePages } from './sitePages.mjs';

const files = sitePages();

/**
 * Markdown of a page without the site's own elements, with links that hold beside it.
 *
 * @param {string} name - path of the page from `pagesFolder`
 */
export function textOf(name) {
  return readPage(/** @type {string} */ (files.get(name)))
    .replace(/^<(Live|Costs|Drawing)\b.*\/>\n/gm, '')
    .replace(/^<\/?div.*>\n/gm, '')
    .replace(/(?<!!)\]\(([^)\s]+)\)/g, (_link, href) => `](${siteLink(href, name, files)})`);
}

/** Description of a page, from its front matter. @param {string} name - path of the page from `pagesFolder` */
function descriptionOf(name) {
  const [, text = ''] = /^description: (.*)$/m.exec(readFileSync(join(root, pagesFolder, name), 'utf8')) ?? [];
  return text.replace(/^"(.*)"$/, '$1');
}

/**
 * Writes into the built site: each page's Markdown beside it, `llms.txt` which lists them, `llms-full.txt` which is all of
 * them, and for each page without a Spanish text a Spanish address that leads to the English one.
 *
 * @param {string} dist
 * @param {{ text: string, items: { text: string, link: string }[] }[]} groups - of the pages, in the reader's order
 */
export function writeTexts(dist, groups) {
  for (const name of files.keys()) write(join(dist, name), `${textOf(name)}\n`);
  const nameOf = (/** @type {string} */ link) => `${link.slice(1)}${link.endsWith('/') ? 'index' : ''}.md`;
  const lines = groups.flatMap(({ text, items }) => [
    `\n## ${text}\n`,
    ...items.map(({ text, link }) => `- [${text}](${nameOf(link)}): ${descriptionOf(nameOf(link))}`),
  ]);
  const about = descriptionOf('index.md');
  writeFileSync(join(dist, 'llms.txt'), `# Farol\n\n> ${about}\n${lines.join('\n')}\n`);
  const all = groups.flatMap(({ items }) => items.map(({ link }) => textOf(nameOf(link))));
  writeFileSync(join(dist, 'llms-full.txt'), `${all.join('\n\n---\n\n')}\n`);
  const pages = readdirSync(dist, { recursive: true, encoding: 'utf8' }).map((name) => name.replaceAll('\\', '/'));
  for (const page of pages) {
    if (!page.endsWith('.html') || page === '404.html' || page.startsWith('es/') || existsSync(join(dist, 'es', page)))
      continue;
    const to = `${'../'.repeat(page.split('/').length)}${page}`;
    const head = `<title>Farol</title><meta http-equiv="refresh" content="0; url=${to}" />`;
    write(join(dist, 'es', page), `<!doctype html>${head}\n`);
  }
}

/** @param {string} path @param {string} text */
function write(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}
