import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { dirname, normalize, relative } from 'node:path/posix';
import { root } from '../root.mjs';

/** Folder of the site's pages, from the repository's root. */
export const pagesFolder = 'apps/site/pages';

/** Address under which the repository's other files are read. */
export const repository = JSON.parse(readFileSync(join(root, 'packages/renderer/package.json'), 'utf8'))
  .repository.url.replace(/^git\+/, '')
  .replace(/\.git$/, '');

const includes = /^<!--@include: ([^\s#]+?)(#[\w-]+)?-->$/gm;
const frontMatter = /^---\n.*?\n---\n/s;

/**
 * Pages of the site. A page that is nothing but an include has the included document as its source: the text is written
 * once, with links relative to the document.
 *
 * @returns {Map<string, string>} path of the source from the repository's root, by path of the page from `pagesFolder`
 */
export function sitePages() {
  const names = readdirSync(join(root, pagesFolder), { recursive: true, encoding: 'utf8' })
    .map((name) => name.replaceAll('\\', '/'))
    // names in brackets stand for pages that a script lists: the examples of the gallery
    .filter((name) => name.endsWith('.md') && !name.includes('['));
  return new Map(
    names.toSorted().map((name) => {
      const path = `${pagesFolder}/${name}`;
      const [include] = readFileSync(join(root, path), 'utf8').replace(frontMatter, '').trim().matchAll(includes);
      const isWhole = include !== undefined && include[2] === undefined && include[0] === include.input;
      return [name, isWhole ? normalize(join(dirname(path), include[1])) : path];
    }),
  );
}

/**
 * Markdown of a page, with what it includes, without its front matter.
 *
 * @param {string} path - from the repository's root
 * @returns {string}
 */
export function readPage(path) {
  return readFileSync(join(root, path), 'utf8')
    .replace(frontMatter, '')
    .replace(includes, (_include, file, region) => {
      const text = readPage(normalize(join(dirname(path), file)));
      if (region === undefined) return text;
      const name = region.slice(1);
      return text.split(`<!-- #region ${name} -->`)[1].split(`<!-- #endregion ${name} -->`)[0];
    })
    .trim();
}

/**
 * Anchor of a heading, as GitHub makes it.
 *
 * @param {string} heading - without markup
 */
export const githubSlug = (heading) =>
  heading
    .trim()
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\p{M}\s_-]/gu, '')
    .replace(/\s/g, '-');

/**
 * Address of a link of a document, as the page that shows it must write it: of another page where there is one, of the
 * repository's file otherwise.
 *
 * @param {string} href - as the document has it
 * @param {string} page - path of the page from `pagesFolder`
 * @param {ReadonlyMap<string, string>} pages - see `sitePages`
 * @returns {string}
 */
export function siteLink(href, page, pages) {
  const source = pages.get(page);
  if (source === undefined || /^([a-z]+:|#|\/)/i.test(href)) return href;
  const [path, hash] = href.split('#');
  const target = normalize(join(dirname(source), path)).replace(/\/$/, '');
  const end = hash === undefined ? '' : `#${hash}`;
  const wanted = [target, `${target}/README.md`];
  const isSpanish = page.startsWith('es/');
  const found = [...pages].filter(([name, file]) => wanted.includes(file) || target === `${pagesFolder}/${name}`);
  const [to] = found.find(([name]) => name.startsWith('es/') === isSpanish) ?? found[0] ?? [];
  if (to !== undefined) return `${relativeTo(page, to)}${end}`;
  return existsSync(join(root, target)) ? `${repository}/blob/main/${target}${end}` : href;
}

/**
 * Address of a picture of a document, relative to the page that shows it.
 *
 * @param {string} source - as the document has it
 * @param {string} page - path of the page from `pagesFolder`
 * @param {ReadonlyMap<string, string>} pages - see `sitePages`
 */
export function sitePicture(source, page, pages) {
  const document = pages.get(page);
  if (document === undefined || /^([a-z]+:|\/)/i.test(source)) return source;
  return relativeTo(`${pagesFolder}/${page}`, normalize(join(dirname(document), source)));
}

/** @param {string} from - a file @param {string} to - a file of the same root */
function relativeTo(from, to) {
  const path = relative(dirname(from), to);
  return path.startsWith('.') ? path : `./${path}`;
}

/**
 * markdown-it plugin: links and pictures of included documents, for the page that shows them.
 *
 * @param {import('vitepress').MarkdownRenderer} md
 * @param {ReadonlyMap<string, string>} pages - see `sitePages`
 */
export function rewriteLinks(md, pages) {
  md.core.ruler.push('farol-site-links', (state) => {
    const page = state.env.relativePath ?? '';
    for (const block of state.tokens) {
      // a table that is wider than a phone scrolls, by the keyboard too
      if (block.type === 'table_open') block.attrSet('tabindex', '0');
      for (const token of block.children ?? []) {
        // braces in code are no expressions of Vue's
        if (token.type === 'code_inline') token.attrSet('v-pre', '');
        const name = token.type === 'link_open' ? 'href' : token.type === 'image' ? 'src' : '';
        const value = name && token.attrGet(name);
        if (!value) continue;
        token.attrSet(name, name === 'href' ? siteLink(value, page, pages) : sitePicture(value, page, pages));
      }
    }
  });
}
