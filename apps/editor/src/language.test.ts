import { englishLabelOfField } from '@farol/editing';
import { builtinComponents, Scene } from '@farol/engine';
import { type ChoiceField, type FieldTable, materialAssetFields } from '@farol/engine/fields';
import { techniques, views } from '@farol/renderer';
import { expect, test } from 'vitest';
import { sourceFiles } from '@farol/tools/sourceFiles';
import { propertyTexts, tableOf, textsOf } from '@farol/tools/texts';
import { actions } from './actions';
import { englishViewLabel } from './actions/pictureActions';
import { es } from './language/es';
import { samples } from './api/Sample';
import { firstLanguage } from './language/languages';
import { creations } from './model/creations';
import { panels } from './panels';

const sources = [...sourceFiles()].filter(([path]) => !/\.(test|bench)\.tsx?$|\/testing\//.test(path));
const below = (...folders: string[]): [string, string][] =>
  sources.filter(([path]) => folders.some((folder) => path.startsWith(`${folder}/`)));
const editor = below('apps/editor/src', 'packages/editing/src');

const words = (name: string): string => name.replaceAll(/([a-z])([A-Z])/g, '$1 $2');

const choicesOf = ({ options, optionLabels = {} }: ChoiceField): string[] =>
  options.map((option) => optionLabels[option] ?? option);

const ofFields = (fields: FieldTable): string[] =>
  Object.entries(fields).flatMap(([name, field]) => [
    englishLabelOfField(name, field),
    field.help,
    field.group ?? '',
    ...Object.values(field.variants?.of ?? {}).flatMap(({ label }) => label ?? []),
    // symbols of units, such as 'm/s', are not translated
    ...('unit' in field && field.unit && /\p{L}{4}| /u.test(field.unit) ? [field.unit] : []),
    ...(field.kind === 'choice' ? choicesOf(field) : []),
    ...(field.kind === 'object' && field.noneLabel ? [field.noneLabel] : []),
  ]);

/** Every text that the editor may look up. */
function wantedTexts(): Set<string> {
  const scene = new Scene();
  const texts = [
    ...editor.flatMap(([path, source]) => textsOf(path, source).texts),
    ...actions.flatMap(({ label, menu }) => [typeof label === 'string' ? label : '', menu?.submenu ?? '']),
    ...editor.flatMap(([path, source]) => propertyTexts(path, source, 'submenu')),
    ...panels.map(({ title }) => title),
    ...Object.values(samples).map(({ help }) => help),
    ...creations(scene).flatMap(({ label, folder }) => [label, folder ?? '']),
    ...[...builtinComponents.types.values()].flatMap((type) => [
      words(type.typeName),
      type.help,
      ...ofFields(type.fields),
    ]),
    ...ofFields(scene.settings.fields),
    ...ofFields(materialAssetFields),
    ...Object.values(techniques).flatMap(({ label, help }) => [label, help]),
    ...views.map(englishViewLabel),
    ...below('packages/engine/src').flatMap(([path, source]) => propertyTexts(path, source, 'help', 'label')),
    ...below('packages/renderer/src/renderer').flatMap(([path, source]) => propertyTexts(path, source, 'reason')),
    ...below('apps/editor/src/plugins').flatMap(([path, source]) =>
      propertyTexts(path, source, 'help', 'label', 'title'),
    ),
  ];
  // single letters, signs and numbers are not translated
  return new Set(texts.filter((text) => /\p{L}{2}/u.test(text)));
}

const placeholders = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).toSorted();

test('everything that the editor shows is there in Spanish, and nothing that it does not show', () => {
  const wanted = wantedTexts();
  expect(wanted.size).toBeGreaterThan(600);
  expect([...wanted].filter((text) => !Object.hasOwn(es, text))).toEqual([]);
  expect(Object.keys(es).filter((text) => !wanted.has(text))).toEqual([]);
});

test('a Spanish text has the values of its English one, and its blanks at both ends', () => {
  const unlike = Object.entries(es).filter(
    ([english, spanish]) =>
      placeholders(english).join() !== placeholders(spanish).join() ||
      /^\s*/.exec(english)![0] !== /^\s*/.exec(spanish)![0] ||
      /\s*$/.exec(english)![0] !== /\s*$/.exec(spanish)![0] ||
      spanish.trim() === '',
  );
  expect(unlike).toEqual([]);
});

test('whatever the editor shows is looked up in the language that is shown', () => {
  const faults = below('apps/editor/src', 'packages/editing/src', 'packages/attach/src').flatMap(
    ([path, source]) => textsOf(path, source).faults,
  );
  expect(faults).toEqual([]);
});

test('the attached editor has the same words', () => {
  const texts = below('packages/attach/src/language').flatMap(([path, source]) =>
    Object.entries(tableOf(path, source)),
  );
  expect(texts.length).toBeGreaterThan(100);
  expect(texts.filter(([english, spanish]) => Object.hasOwn(es, english) && es[english] !== spanish)).toEqual([]);
});

test('the language is the chosen one, else the first of the browser, else English', () => {
  expect(firstLanguage('en', ['es-MX'])).toBe('en');
  expect(firstLanguage(null, ['de-DE', 'es-419', 'en'])).toBe('es');
  expect(firstLanguage('klingon', ['fr'])).toBe('en');
  expect(firstLanguage(undefined, [])).toBe('en');
});
