import { englishLabelOfField } from '@farol/editing';
import { techniques } from '@farol/renderer';
import { languageGaps } from '@farol/tools/languageGaps';
import { sourceFiles } from '@farol/tools/sourceFiles';
import { viewProblems } from '@farol/tools/viewProblems';
import { textsOf } from '@farol/tools/texts';
import { expect, test } from 'vitest';
import { cameraProperties } from '../fields/cameraProperties';
import { lightProperties } from '../fields/lightProperties';
import { materialProperties } from '../fields/materialProperties';
import { objectProperties, transformProperties } from '../fields/objectProperties';
import { es } from './es';

const properties = [
  ...[...transformProperties, ...objectProperties, ...lightProperties],
  ...[...cameraProperties, ...materialProperties],
];

const labels = Object.fromEntries(Object.entries(techniques).map(([name, { label }]) => [name, [label]]));

/** Texts of the attached editor besides those of techniques. */
function otherTexts(): string[] {
  const sources = [...sourceFiles()].filter(
    ([path]) => /^packages\/(attach|editing)\/src\//.test(path) && !path.endsWith('.test.ts'),
  );
  const texts = [
    ...sources.flatMap(([path, source]) => textsOf(path, source).texts),
    ...viewProblems(),
    ...properties.flatMap(({ name, field }) => [
      englishLabelOfField(name, field),
      field.help,
      ...(field.kind === 'choice' ? field.options : []),
    ]),
  ];
  return texts.filter((text) => /\p{L}{2}/u.test(text));
}

test('everything that the attached editor shows is there in Spanish, and nothing that it does not show', () => {
  const others = otherTexts();
  const wanted = new Set([...others, ...Object.values(labels).flat()]);
  expect(wanted.size).toBeGreaterThan(150);
  expect(languageGaps(others, labels, es)).toEqual([]);
  expect(Object.keys(es).filter((text) => !wanted.has(text))).toEqual([]);
});
