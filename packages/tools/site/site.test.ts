import { existsSync, readdirSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path/posix';
import { describe, expect, it } from 'vitest';
import { publishedPackages } from '../publishedPackages.mjs';
import { root } from '../root.mjs';
import { readSpanish } from './galleryExamples.mjs';
import { scriptWithBase } from './relativeBase.mjs';
import { searchOptions } from './searchOptions.mjs';
import { searchIndex, sectionsOf } from './searchPages.mjs';
import { pagesFolder, readPage, siteLink, sitePages, sitePicture } from './sitePages.mjs';
import { apiTexts, textOf } from './writeTexts.mjs';

const pages = sitePages();
const anchors = new Map(
  [...pages].map(([name, source]) => [name, new Set(sectionsOf(readPage(source)).map(({ anchor }) => anchor))]),
);

/** Links and pictures of a page's Markdown, code left out. */
function linksOf(source: string): { address: string; isPicture: boolean }[] {
  const text = readPage(source)
    .replace(/^(```+).*?^\1/gms, '')
    .replace(/`[^`\n]*`/g, '');
  return [...text.matchAll(/(!?)\[(?:[^\][]|\[[^\]]*\])*\]\(([^)\s]+)\)/g)].map(([, mark, address]) => ({
    address,
    isPicture: mark === '!',
  }));
}

describe('links of the site', () => {
  it.each([...pages])('of %s lead to pages, headings and pictures that are there', (page, source) => {
    const faults = linksOf(source).flatMap(({ address, isPicture }) => {
      if (isPicture) {
        const file = sitePicture(address, page, pages);
        return /^https?:/.test(file) || existsSync(join(root, pagesFolder, dirname(page), file)) ? [] : [address];
      }
      const link = siteLink(address, page, pages);
      if (/^[a-z]+:/.test(link)) return [];
      const [path, anchor] = link.split('#');
      const target = path === '' ? page : normalize(join(dirname(page), path));
      const found = anchors.get(target);
      return found !== undefined && (anchor === undefined || found.has(anchor)) ? [] : [`${address} (${link})`];
    });
    expect(faults).toEqual([]);
  });

  it('of the bars lead to pages, and to each page but those within another group', async () => {
    const { english, groups, spanish } = await import('../../../apps/site/.vitepress/navigation.mjs');
    const links = [
      ...groups.flatMap(({ items }) => items),
      ...english.nav,
      ...spanish.themeConfig.nav,
      ...spanish.themeConfig.sidebar['/es/'].flatMap(({ items }) => items),
    ].map(({ link }) => `${link.slice(1)}${link.endsWith('/') ? 'index' : ''}.md`);
    const known = new Set([...pages.keys(), 'api/index.md']);
    expect(links.filter((name) => !known.has(name))).toEqual([]);
    const others = [...pages.keys()].filter((name) => !/^(es\/)?(index\.md|gallery\/|thesis\/|api\/)/.test(name));
    expect(others.filter((name) => !links.includes(name))).toEqual([]);
  });
});

it('has a page for each document of the packages and of the editor', () => {
  const sources = new Set(pages.values());
  const folders = [...publishedPackages().map(({ folder }) => folder), 'apps/editor'];
  const documents = folders.flatMap((folder) => {
    const docs = join(root, folder, 'docs');
    const names = existsSync(docs) ? readdirSync(docs, { recursive: true, encoding: 'utf8' }) : [];
    return [
      `${folder}/README.md`,
      ...names.filter((name) => name.endsWith('.md')).map((name) => `${folder}/docs/${name}`),
    ];
  });
  expect(documents.length).toBeGreaterThan(30);
  expect(documents.filter((path) => !sources.has(path.replaceAll('\\', '/')))).toEqual([]);
});

describe('the search', () => {
  const index = searchIndex();
  const first = (query: string): string => index.search(query)[0]?.id ?? '';
  /** Questions of newcomers, each with words that somebody in a hurry types, and the page that answers. */
  const questions: [question: string, words: string, page: string][] = [
    ['How do I install it?', 'how to install', 'guides/faq.md'],
    ['Why is my scene black, or dark?', 'black scene', 'guides/faq.md'],
    ['How far does a light reach, and how do I set it?', 'light range', 'guides/lights.md'],
    ['How many lights, how many shadows?', 'how many lights', 'guides/lights.md'],
    ['Why is transparency slow?', 'transparency slow', 'guides/faq.md'],
    ['How do I use my ShaderMaterial or onBeforeCompile?', 'onBeforeCompile', 'guides/faq.md'],
    ['How do I get bloom?', 'bloom', 'guides/effects.md'],
    ['With EffectComposer?', 'EffectComposer', 'guides/faq.md'],
    ["With pmndrs' postprocessing?", 'postprocessing', 'guides/faq.md'],
    ['InstancedMesh? BatchedMesh?', 'BatchedMesh', 'guides/many-objects.md'],
    ['WebXR? WebGPURenderer? Node materials?', 'WebGPU', 'guides/faq.md'],
    ['How do I dispose?', 'dispose', 'guides/faq.md'],
    ['Several canvases without React?', 'several canvases', 'guides/canvas.md'],
    ['OffscreenCanvas in a worker?', 'worker', 'guides/canvas.md'],
    ['Rendering to a target?', 'render target', 'guides/canvas.md'],
    ['A transparent canvas?', 'transparent canvas', 'guides/canvas.md'],
    ['Resizing, pixel ratio?', 'resize', 'guides/canvas.md'],
    ['Multisampling, `antialias: true`?', 'antialias', 'guides/faq.md'],
    ['Tone mapping, output colour space?', 'tone mapping', 'guides/canvas.md'],
    ['Phones?', 'phones', 'guides/faq.md'],
    ['How do I write a technique?', 'write a technique', 'guides/authoring.md'],
    ['How do I profile?', 'FPS', 'guides/faq.md'],
    ['Which versions of three?', 'versions of three', 'guides/compatibility.md'],
    ['From ClusteredLighting?', 'ClusteredLighting', 'guides/faq.md'],
    ['With an import map, from a CDN?', 'import map', 'guides/faq.md'],
    ['What happens in the first frames, while code is fetched?', 'first frames', 'guides/renderer.md'],
    ['Which browsers?', 'which browsers', 'guides/faq.md'],
  ];

  it('has all questions of the page of questions in this table', () => {
    const asked = sectionsOf(readPage('packages/renderer/docs/faq.md')).slice(1);
    expect(questions.map(([question]) => question.replaceAll('`', ''))).toEqual(asked.map(({ title }) => title));
  });

  it.each(questions)('answers "%s", and "%s", on the first page found', (question, words, page) => {
    const anchor = sectionsOf(`## ${question}`)[0].anchor;
    const found = first(question);
    expect(found === `guides/faq.md#${anchor}` || found.startsWith(page), found).toBe(true);
    const [file, at] = first(words).split('#');
    expect(file).toBe(page);
    if (file === 'guides/faq.md') expect(at).toBe(anchor);
  });

  it('finds the examples of the gallery by their titles, sentences and tags, in both languages', () => {
    expect(first('campfire')).toBe('gallery/campfire.md');
    expect(first('toon')).toBe('gallery/microshader-toon.md');
    const { _splitIntoSections: split } = searchOptions.miniSearch;
    const [spanish] = split('/pages/es/gallery/lamps-in-fog.md');
    expect(spanish.titles).toEqual([readSpanish().examples['lamps-in-fog'][0], 'Ejemplo']);
    expect(spanish.text).toContain('niebla');
    expect(split('/pages/gallery/index.md')).toBeUndefined();
  });
});

it('makes strings of scripts that hold the base take it from the page', () => {
  const text = 'const a="/FAROL_SITE_BASE/assets/x.js",b=`${c}/FAROL_SITE_BASE/`,d="other";';
  const run = new Function('c', `${scriptWithBase('x.js', text)} return [a, b, d];`) as (c: string) => string[];
  (globalThis as { FAROL_SITE_BASE?: string }).FAROL_SITE_BASE = '/sub/folder/';
  expect(run('')).toEqual(['/sub/folder/assets/x.js', '/sub/folder/', 'other']);
  delete (globalThis as { FAROL_SITE_BASE?: string }).FAROL_SITE_BASE;
});

it('gives machines pages without elements of the site, with links that hold beside them', () => {
  const text = textOf('techniques/deferred.md');
  expect(text).toMatch(/^# Deferred shading/);
  expect(text).not.toMatch(/<[A-Z]/);
  expect(textOf('guides/faq.md')).toContain('](./lights.md#give-each-light-a-range)');
  expect(textOf('guides/faq.md')).toContain('](./lab.md)');
});

it('gives machines the API with its examples, as Markdown without marks of the site', () => {
  const text = apiTexts().find(({ name }) => name === 'api/renderer-light-field.md')!.text;
  expect(text).toContain('\n## LightField\n');
  expect(text).toContain('new LightField(10_000)');
  expect(apiTexts().filter(({ text }) => /&lt;|&#123;|^#+ .*\{#/m.test(text))).toEqual([]);
});
