import MiniSearch from 'minisearch';
import { apiPages } from './api/apiPages.mjs';
import { searchOptions } from './searchOptions.mjs';
import { readExamples } from './galleryExamples.mjs';
import { githubSlug, readPage, sitePages } from './sitePages.mjs';

/** A section of a page, as the site's search knows it. @typedef {{ id: string, title: string, titles: string[], text: string }} Section */

/** Words of a line of Markdown, without its markup. @param {string} line */
export const plainText = (line) =>
  line
    .replace(/!?\[([^\]]*)\]\([^)]*\)/g, '$1')
    .replace(/<[^>]+>/g, '')
    .replace(/(\*\*|__|`)(.*?)\1/g, '$2')
    .replace(/(?<![\w*])[*_](\S.*?)[*_](?!\w)/g, '$1');

/**
 * Sections of a page: a heading and the text below it, up to the next heading.
 *
 * @param {string} markdown
 * @returns {{ level: number, title: string, anchor: string, text: string }[]} anchors as the site and GitHub make them
 */
export function sectionsOf(markdown) {
  /** @type {{ level: number, title: string, anchor: string, text: string }[]} */
  const found = [];
  /** @type {Map<string, number>} */
  const seen = new Map();
  let fence = '';
  for (const line of markdown.split('\n')) {
    const [, mark = ''] = /^\s*(```+|~~~+)/.exec(line) ?? [];
    if (mark !== '' && fence === '') fence = mark;
    else if (mark !== '' && mark.startsWith(fence)) fence = '';
    const heading = fence === '' ? /^(#{1,6}) (.+)$/.exec(line) : null;
    if (heading) {
      const title = plainText(heading[2]);
      const slug = githubSlug(title);
      const times = seen.get(slug) ?? 0;
      seen.set(slug, times + 1);
      found.push({ level: heading[1].length, title, anchor: times === 0 ? slug : `${slug}-${times}`, text: '' });
    } else if (found.length > 0) found[found.length - 1].text += `${fence === '' ? plainText(line) : line}\n`;
  }
  return found;
}

/**
 * Sections of the site's English pages.
 *
 * @returns {Section[]}
 */
export function sections() {
  const pages = [...sitePages()].flatMap(([name, source]) => {
    if (name.startsWith('es/')) return [];
    /** @type {string[]} */
    const above = [];
    return sectionsOf(readPage(source)).map(({ level, title, anchor, text }) => {
      above.length = Math.min(above.length, level - 1);
      const titles = above.filter(Boolean);
      above[level - 1] = title;
      return { id: `${name}#${anchor}`, title, titles, text };
    });
  });
  const scripted = [
    ...apiPages().pages.map(({ name }) => `api/${name}.md`),
    ...readExamples().map(({ name }) => `gallery/${name}.md`),
  ].flatMap((page) =>
    searchOptions.miniSearch._splitIntoSections(page).map(({ anchor, titles: [above, title], text }) => {
      return { id: anchor ? `${page}#${anchor}` : page, title, titles: [above], text };
    }),
  );
  return [...pages, ...scripted];
}

/**
 * Index of the site's search, of the same texts by the same options; VitePress makes its own of the rendered pages.
 *
 * @returns {{ search: (query: string) => { id: string }[] }}
 */
export function searchIndex() {
  const index = new MiniSearch({
    fields: ['title', 'titles', 'text'],
    storeFields: ['title', 'titles'],
    ...searchOptions.miniSearch.options,
  });
  index.addAll(sections());
  return { search: (query) => index.search(query, searchOptions.miniSearch.searchOptions) };
}
