import { es as editing, esOfApps } from '@farol/editing/es';
import { techniques } from '@farol/renderer';
import { languageGaps } from '@farol/tools/languageGaps';
import { sourceFiles } from '@farol/tools/sourceFiles';
import { tableOf, textsOf } from '@farol/tools/texts';
import { expect, test } from 'vitest';
import { competitorNames } from '../competitors/competitorNames';
import { lightKinds, shadings } from '../plan/lightKinds';
import { presets } from '../plan/presets';
import { axisWords, sceneWords } from '../plan/sceneWords';
import { exportFormats } from '../results/exportRun';
import { columnsOf } from '../ui/results/rowColumns';
import { metricWords } from '../words/names';
import { es } from './es';

const sources = [...sourceFiles()].filter(([path]) => !/\.test\.tsx?$/.test(path));
const lab = sources.filter(([path]) => path.startsWith('apps/lab/src/'));
const inFile = (end: string): [string, string][] => lab.filter(([path]) => path.endsWith(end));

const words = (table: object): string[] =>
  Object.values(table).flatMap((each: object) => Object.values(each) as string[]);

/** Labels of Farol's techniques contain keys, which are the same in each language. */
const ofCompetitors = Object.entries(competitorNames).flatMap(([name, { label, help }]) =>
  name in techniques ? [] : [label, help],
);

const entries: Record<string, string[]> = Object.fromEntries(
  Object.entries(techniques).map(([name, { help }]) => [`technique ${name}`, [help]]),
);

function allTexts(): string[] {
  return [
    ...lab.flatMap(([path, source]) => textsOf(path, source).texts),
    ...ofCompetitors,
    ...Object.values(presets).flatMap(({ label, help }) => [label, help]),
    ...Object.values(sceneWords).flatMap(({ label, help }) => [label, help]),
    ...[lightKinds, shadings, axisWords, metricWords].flatMap(words),
    ...['Farol’s techniques', 'Other engines', 'System', 'Light##theme', 'Dark', 'Custom', 'other passes'],
    'A software rasteriser draws here, on the processor: its figures say little about graphics cards.',
    ...['First frame', 'Ten lights more', 'Technique changed', 'Rasteriser'],
    ...['light', 'object', 'pixel', 'layer', 'shadowed light', 'kinds of lights', 'shadings'],
    ...columnsOf([]).flatMap(({ label, help }) => [label, help]),
    ...['N × N planes, M × M lights', 'Sponza (here: atrium)'],
    ...Object.values(exportFormats).map(({ help }) => help),
    ...['words/names.ts', 'Comparison.tsx'].flatMap((end) =>
      inFile(end).flatMap(([path, source]) => Object.values(tableOf(path, source))),
    ),
  ].filter((text) => /\p{L}{2}/u.test(text));
}

/** English texts that lack a Spanish one, and are shown in English: the list may only get shorter. */
const gaps: readonly string[] = [];

test('the Lab’s texts are there in Spanish but the gaps, and nothing that it does not show', () => {
  const others = allTexts();
  const wanted = new Set([...others, ...Object.values(entries).flat()]);
  expect(wanted.size).toBeGreaterThan(350);
  expect(languageGaps(others, entries, es)).toEqual(gaps);
  expect(Object.keys(es).filter((text) => !wanted.has(text) && !(text in editing || text in esOfApps))).toEqual([]);
});

test('a Spanish text has the values of its English one', () => {
  const placeholders = (text: string): string => (text.match(/\{\w+\}/g) ?? []).toSorted().join();
  expect(Object.entries(es).filter(([english, spanish]) => placeholders(english) !== placeholders(spanish))).toEqual(
    [],
  );
});

test('whatever the Lab shows is looked up in the language that is shown', () => {
  expect(lab.flatMap(([path, source]) => textsOf(path, source).faults)).toEqual([]);
});
