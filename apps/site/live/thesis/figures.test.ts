import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';

/**
 * Every figure and table of chapters 2, 3.1 and 4 of the thesis, the window of 3.2.7, and the subjects that it explains
 * without a picture: its section with a number within it, since the thesis's figures have captions and no numbers
 * (`beyond` for what goes beyond it); kind; page; module; parameters of the module.
 */
const figures = `
2.2-1 figure light-and-shading pipeline
2.2.1.1-1 figure light-and-shading phong
2.2.1.2-1 figure light-and-shading shading
2.2.1.3-1 figure light-and-shading lights
2.2.1.3-2 subject multipass many-lights
2.2.2-1 figure multipass multipass
2.2.2-2 subject multipass complexity
2.2.3-1 figure deferred steps &technique=deferred
2.2.3.1-1 table deferred gbuffer
2.2.3.1.1-1 subject deferred depth
2.2.3.1.2-1 subject deferred position
2.2.3.2-1 subject deferred complexity &objects=37&lights=50
2.2.3.3.1-1 figure variants gbuffer &buffer=normal&from=0.5
2.2.3.3.2-1 figure variants steps &technique=light-prepass
2.2.3.3.3-1 figure variants steps &technique=inferred
2.2.3.3.4-1 figure variants steps &technique=tiled-deferred
2.2.3.3.4-2 subject variants steps &technique=tiled-forward
2.2.3.3.5-1 figure variants culling
2.2.3.3.5-2 subject variants steps &technique=forward-plus
2.2.4-1 subject variants complexity &objects=17&lights=20
beyond-1 subject variants steps &technique=clustered-deferred
beyond-2 subject variants steps &technique=clustered-forward
3.1-1 subject engine-design engine
3.1.1-1 table engine-design position &show=stored
3.1.1-2 table engine-design position &show=error&bits=24
3.1.2-1 table engine-design microshaders &light=light_point
3.1.2-2 figure engine-design microshaders
3.2.7-1 figure scenes scenes &scene=benchmarkLightsObjects
3.2.8-1 subject scenes scenes
4.1-1 figure scenes scenes &n=1&nRows=1&m=15&mRows=15
4.1-2 figure scenes scenes &scene=dragons&lights=24
4.1-3 figure scenes normals &normals=none
4.1-4 figure scenes scenes &scene=temple
4.1-5 figure scenes scenes &scene=niceScene&view=grid&lights=1
4.2.2-1 table results results
4.2.2-2 table results results &table=sponza
4.2.2-3 table results results &table=temple
4.3-1 figure errors aliasing
4.3-2 figure errors normals`
  .trim()
  .split('\n')
  .map((line) => {
    const [id, kind, page, module, query = ''] = line.split(' ');
    const [section] = id.split('-');
    return { id, section, kind, page, tag: `thesis/${module}${query}`, module };
  });

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const pageOf = (folder: string, page: string): string => readFileSync(at(`../../pages/${folder}/${page}.md`), 'utf8');
/** Module and parameters of each figure of a page; one without a title is none. */
const tagsOf = (text: string): string[] =>
  [...text.matchAll(/<Live name="([^"]+)"(?: query="([^"]+)")? title="[^"]+"/g)].map(
    ([, name, query = '']) => name + query,
  );

/** Figures, tables and subjects that the thesis has in a chapter, and those beyond it. */
const counts = (chapter: string): Record<string, number> => {
  const numbers: Record<string, number> = { figure: 0, table: 0, subject: 0 };
  for (const { kind, section } of figures) if (section.startsWith(chapter)) numbers[kind]++;
  return numbers;
};

describe('the list of figures', () => {
  test('has all that the thesis has', () => {
    // captions and tables of its text, counted by hand
    expect(counts('2')).toMatchObject({ figure: 11, table: 1 });
    expect(counts('3.1')).toMatchObject({ figure: 1, table: 3 });
    expect(counts('4')).toMatchObject({ figure: 7, table: 3 });
    expect(new Set(figures.map(({ id }) => id)).size).toBe(figures.length);
  });

  test.each(figures.map((figure) => [figure.id, figure] as const))(
    '%s has a module and stands in the pages of both languages',
    (_id, { module, page, tag, section }) => {
      expect(existsSync(at(`./${module}.ts`))).toBe(true);
      for (const folder of ['thesis', 'es/thesis']) {
        const text = pageOf(folder, page);
        expect(tagsOf(text)).toContain(tag);
        if (section !== 'beyond') expect(text).toContain(section);
      }
    },
  );

  test.each(['thesis', 'es/thesis'])('names each figure of the pages: %s', (folder) => {
    const pages = readdirSync(at(`../../pages/${folder}`)).map((name) => pageOf(folder, name.replace('.md', '')));
    for (const text of pages) expect(tagsOf(text)).toHaveLength(text.split('<Live ').length - 1);
    expect(pages.flatMap(tagsOf).toSorted()).toEqual(figures.map(({ tag }) => tag).toSorted());
  });

  test('names each module', () => {
    const modules = readdirSync(at('.')).filter((name) => name.endsWith('.ts') && !name.startsWith('figures'));
    expect(new Set(figures.map(({ module }) => `${module}.ts`))).toEqual(new Set(modules));
  });
});
