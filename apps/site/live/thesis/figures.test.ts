import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, test } from 'vitest';
import { figures } from './figures';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));
const pageOf = (folder: string, page: string): string => readFileSync(at(`../../pages/${folder}/${page}.md`), 'utf8');

/** Figures, tables and subjects that the thesis has in a chapter, and those beyond it. */
const counts = (chapter: string): Record<string, number> => {
  const numbers = { figure: 0, table: 0, subject: 0 };
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
    (_id, { module, page, query, section, title }) => {
      expect(existsSync(at(`./${module}.ts`))).toBe(true);
      for (const [folder, words] of [
        ['thesis', title[0]],
        ['es/thesis', title[1]],
      ]) {
        const text = pageOf(folder, page);
        const tag = `<Live name="thesis/${module}"${query === '' ? '' : ` query="${query}"`} title="${words}"`;
        expect(text).toContain(tag);
        expect(text).toContain(section);
      }
    },
  );

  test('names each figure of the pages', () => {
    for (const [folder, language] of [
      ['thesis', 0],
      ['es/thesis', 1],
    ] as const) {
      const names = readdirSync(at(`../../pages/${folder}`));
      const titles = names.flatMap((name) => [
        ...pageOf(folder, name.replace('.md', '')).matchAll(/<Live [^>]*title="([^"]+)"/g),
      ]);
      expect(titles.map(([, title]) => title).toSorted()).toEqual(
        figures.map(({ title }) => title[language]).toSorted(),
      );
    }
  });

  test('names each module', () => {
    const modules = readdirSync(at('.')).filter((name) => name.endsWith('.ts') && !name.startsWith('figures'));
    expect(new Set(figures.map(({ module }) => `${module}.ts`))).toEqual(new Set(modules));
  });
});
