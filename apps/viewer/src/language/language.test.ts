import { englishLabelOfField } from '@farol/editing';
import { es as editing, esOfApps } from '@farol/editing/es';
import type { FieldTable } from '@farol/engine/fields';
import { techniques, views } from '@farol/renderer';
import { scenes } from '@farol/scenes';
import { languageGaps } from '@farol/tools/languageGaps';
import { sourceFiles } from '@farol/tools/sourceFiles';
import { viewProblems } from '@farol/tools/viewProblems';
import { propertyTexts, textsOf } from '@farol/tools/texts';
import { expect, test } from 'vitest';
import { modelParameters } from '../model/modelScene';
import { effectEntries } from '../state/effectParameters';
import { es } from './es';

const sources = [...sourceFiles()].filter(([path]) => !path.endsWith('.test.ts'));
const viewer = sources.filter(([path]) => path.startsWith('apps/viewer/src/'));

const ofFields = (fields: FieldTable): string[] =>
  Object.entries(fields).flatMap(([name, field]) => [englishLabelOfField(name, field), field.help]);

/** Label of a choice in the menu. */
const capital = (name: string): string => name[0].toUpperCase() + name.slice(1).replaceAll('-', ' ');

const entries: Record<string, string[]> = Object.fromEntries([
  ...Object.entries(techniques).map(([name, { label }]) => [`technique ${name}`, [label]]),
  ...Object.entries(effectEntries).map(([name, { label, help = label, fields = {} }]) => [
    `effect ${name}`,
    // fields without an address parameter: colours
    [
      label,
      help,
      ...Object.values(fields).flatMap((field) => (field.kind === 'number' ? [field.label, field.help] : [])),
    ],
  ]),
  ...Object.entries(scenes).map(([name, { label, help, parameters }]) => [
    `scene ${name}`,
    [label, help, ...ofFields(parameters)],
  ]),
]);

function otherTexts(): string[] {
  return [
    ...viewer.flatMap(([path, source]) => textsOf(path, source).texts),
    ...ofFields(modelParameters),
    ...views.map(capital),
    ...viewProblems(),
    ...['Automatic', 'Full', 'Lite', 'On touch screens', 'On', 'Off ## budget'],
    ...sources
      .filter(([path]) => path.startsWith('packages/renderer/src/renderer/'))
      .flatMap(([path, source]) => propertyTexts(path, source, 'reason')),
  ].filter((text) => /\p{L}{2}/u.test(text));
}

/** English texts without a Spanish one; the list may only get shorter. */
const gaps: readonly string[] = [];

test('the viewer’s texts are there in Spanish but the gaps, and nothing that it does not show', () => {
  const others = otherTexts();
  const wanted = new Set([...others, ...Object.values(entries).flat()]);
  expect(wanted.size).toBeGreaterThan(150);
  expect(languageGaps(others, entries, es)).toEqual(gaps);
  expect(Object.keys(es).filter((text) => !wanted.has(text) && !(text in editing || text in esOfApps))).toEqual([]);
});

test('whatever the viewer shows is looked up in the language that is shown', () => {
  expect(viewer.flatMap(([path, source]) => textsOf(path, source).faults)).toEqual([]);
});
