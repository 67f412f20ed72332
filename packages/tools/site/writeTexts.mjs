import { existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { root } from '../root.mjs';
import { apiIndex, apiPage, apiPages } from './api/apiPages.mjs';
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
 * Markdown of the API's pages, without what only the site reads: anchors of headings, and characters escaped for Vue.
 *
 * @returns {{ name: string, title: string, about: string, text: string }[]} `name` from `pagesFolder`
 */
export function apiTexts() {
  return apiPages().pages.map((page) => ({
    name: `api/${page.name}.md`,
    title: page.title,
    about: page.exports.map(({ name }) => name).join(', '),
    text: apiPage(page)
      .replace(/^(#+ .*) \{#[^}]*\}$/gm, '$1')
      .replaceAll('&lt;', '<')
      .replaceAll('&#123;', '{'),
  }));
}

/**
 * Writes into the built site: each page's Markdown beside it, `llms.txt` which lists them, `llms-full.txt` which is all of
 * them, both with the API, and for each page without a Spanish text a Spanish address that leads to the English one.
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
  const api = apiTexts();
  for (const { name, text } of api) write(join(dist, name), text);
  write(join(dist, 'api/index.md'), apiIndex());
  lines.push('\n## API\n', ...api.map(({ name, title, about }) => `- [${title}](${name}): ${about}`));
  const about = descriptionOf('index.md');
  writeFileSync(join(dist, 'llms.txt'), `# Farol\n\n> ${about}\n${lines.join('\n')}\n`);
  const pagesOfGroups = groups.flatMap(({ items }) => items.map(({ link }) => textOf(nameOf(link))));
  const all = [...pagesOfGroups, ...api.map(({ text }) => text.trim())];
  writeFileSync(join(dist, 'llms-full.txt'), `${all.join('\n\n---\n\n')}\n`);
  const pages = readdirSync(dist, { recursive: true, encoding: 'utf8' }).map((name) => name.replaceAll('\\', '/'));
  for (const page of pages) {
    if (!page.endsWith('.html') || page === '404.html' || page.startsWith('es/') || existsSync(join(dist, 'es', page)))
      continue;
    const to = `${'../'.repeat(page.split('/').length)}${page}`;
    // without an icon a browser asks the host for one
    const icon = '<link rel="icon" href="data:," />';
    const head = `<title>Farol</title>${icon}<meta http-equiv="refresh" content="0; url=${to}" />`;
    write(join(dist, 'es', page), `<!doctype html>${head}\n`);
  }
}

/** @param {string} path @param {string} text */
function write(path, text) {
  mkdirSync(dirname(path), { recursive: true });
  writeFileSync(path, text);
}
