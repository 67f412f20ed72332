import { apiBar } from '@farol/tools/site/api/apiPages';
import { readExamples } from '@farol/tools/site/galleryExamples';
import { makeRelative, placeholderBase } from '@farol/tools/site/relativeBase';
import { liveServer } from '@farol/tools/site/liveServer';
import { githubSlug, rewriteLinks, sitePages } from '@farol/tools/site/sitePages';
import { codeThemes, shownCode } from '@farol/tools/site/shownCode';
import { searchOptions } from '@farol/tools/site/searchOptions';
import { writeTexts } from '@farol/tools/site/writeTexts';
import { defineConfig } from 'vitepress';
import { english, groups, spanish } from './navigation.mjs';

const pages = sitePages();

export default defineConfig(({ command }) => ({
  // a built page finds its base itself when it loads: see relativeBase.mjs
  base: command === 'build' ? placeholderBase : '/',
  srcDir: 'pages',
  outDir: 'dist',
  cacheDir: '../../.cache/vitepress',
  title: 'Farol',
  description: 'Draws ordinary three.js scenes with any number of lights, and edits them while they run.',
  head: [['link', { rel: 'icon', href: 'data:,' }]],
  metaChunk: true,
  locales: {
    root: {
      label: 'English',
      lang: 'en',
      themeConfig: { ...english, sidebar: { '/api/': apiBar(), ...english.sidebar } },
    },
    es: { label: 'Español', lang: 'es', ...spanish },
  },
  themeConfig: {
    search: { provider: 'local', options: searchOptions },
    translated: [
      ...[...pages.keys()].filter((name) => name.startsWith('es/')),
      ...readExamples().map(({ name }) => `es/gallery/${name}.md`),
    ],
  },
  markdown: {
    theme: codeThemes,
    anchor: { slugify: githubSlug },
    toc: { slugify: githubSlug },
    config: (md) => rewriteLinks(md, pages),
  },
  vite: { plugins: [shownCode(), liveServer()], publicDir: false, server: { fs: { allow: ['../..'] } } },
  buildEnd({ outDir }) {
    makeRelative(outDir);
    writeTexts(outDir, groups);
  },
}));
