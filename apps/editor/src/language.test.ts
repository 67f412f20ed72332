import { englishLabelOfField, firstLanguage } from '@farol/editing';
import { builtinComponents, type ComponentClass, effectFields, Scene } from '@farol/engine';
import { type ChoiceField, type FieldTable, materialAssetFields } from '@farol/engine/fields';
import { techniques, views } from '@farol/renderer';
import { type EffectEntry, effects } from '@farol/renderer/effects';
import { languageGaps } from '@farol/tools/languageGaps';
import { expect, test } from 'vitest';
import { sourceFiles } from '@farol/tools/sourceFiles';
import { viewProblems } from '@farol/tools/viewProblems';
import { propertyTexts, tableOf, textsOf } from '@farol/tools/texts';
import { actions } from './actions';
import { englishViewLabel } from './actions/display';
import { es } from './language/es';
import { samples } from './api/Sample';
import { englishWords } from './files/assetKinds';
import { creations } from './model/creations';
import { buildLibraryItem } from './model/library/buildLibraryItem';
import { libraryMaterials } from './model/library/materials';
import { libraryNames } from './model/library/names';
import { libraryTags } from './model/library/tags';
import { panels } from './panels';
import { groupOf } from './panels/palette/paletteItems';
import { registerSceneAssets } from './files/sampleMeshes';

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

const hasLetters = (text: string): boolean => /\p{L}{2}/u.test(text); // single letters, signs and numbers are not translated
const effectEntries = Object.entries<EffectEntry>(effects);
const componentFolder = 'packages/engine/src/components';

/** The texts of a component's class, and of its file. */
const ofComponent = (type: ComponentClass): string[] => [
  words(type.typeName),
  type.help,
  ...ofFields(type.fields),
  ...sources
    .filter(([path]) => path === `${componentFolder}/${type.typeName}.ts`)
    .flatMap(([path, source]) => propertyTexts(path, source, 'help', 'label')),
];

/** The texts of each technique, effect, component and panel that the editor may look up, by kind and name. */
function entryTexts(): Record<string, string[]> {
  const types = [...builtinComponents.types.values()];
  return Object.fromEntries(
    [
      ...Object.entries(techniques).map(([name, { label, help }]) => [`technique ${name}`, [label, help]] as const),
      ...effectEntries
        .filter(([, { setting, group }]) => setting ?? group)
        .map(([name, { label, help = '', fields = {} }]) => {
          const texts = Object.values(fields).flatMap((field) => [field.label, field.help]);
          return [`effect ${name}`, [label, help, ...texts]] as const;
        }),
      ...types.map((type) => [`component ${type.typeName}`, ofComponent(type)] as const),
      ...panels.map(({ id, title }) => {
        const texts = below(`apps/editor/src/panels/${id}`).flatMap(([path, source]) => textsOf(path, source).texts);
        return [`panel ${id}`, [title, ...texts]] as const;
      }),
    ].map(([name, texts]) => [name, texts.filter(hasLetters)]),
  );
}

/** Words of the names of built-in assets. */
const builtinWords = ({ assets }: Scene): string[] =>
  assets.list().map((name) => englishWords(name.replace(/^.*\//, '').replace(/@\d+$|-normal.*$/g, '')));

/** Names of items and materials of the library, of the objects in its prefabs, and its tags. */
function libraryTexts(): string[] {
  const items = Object.values(libraryNames).flatMap((names) => Object.entries<string>(names));
  const objects = items.flatMap(
    ([id]) =>
      buildLibraryItem(id)
        ?.prefab.objects.slice(1)
        .map(({ name }) => name) ?? [],
  );
  return [
    ...items.map(([, name]) => name),
    ...objects,
    ...Object.keys(libraryMaterials),
    ...Object.values(libraryTags).flat(),
  ];
}

/** Texts that the editor may look up besides those of entries. */
function otherTexts(): string[] {
  const scene = new Scene();
  registerSceneAssets(scene.assets);
  const ofEffects = new Set(Object.keys(effectFields));
  const settings = Object.entries(scene.settings.fields).filter(([name]) => !ofEffects.has(name));
  const ownFiles = new Set([...builtinComponents.types.keys()].map((name) => `${componentFolder}/${name}.ts`));
  const isOfPanel = (path: string): boolean =>
    panels.some(({ id }) => path.startsWith(`apps/editor/src/panels/${id}/`));
  const ofEntries = new Set(effectEntries.map(([, { label }]) => label));
  return [
    ...editor.filter(([path]) => !isOfPanel(path)).flatMap(([path, source]) => textsOf(path, source).texts),
    ...actions.flatMap(({ id, label, menu }) => [
      groupOf(id),
      typeof label === 'string' ? label : '',
      menu?.submenu ?? '',
    ]),
    ...editor.flatMap(([path, source]) => propertyTexts(path, source, 'submenu')),
    ...Object.values(samples).map(({ help }) => help),
    ...creations(scene).flatMap(({ label, folder }) => [label, folder ?? '']),
    ...builtinWords(scene),
    ...libraryTexts(),
    ...ofFields(Object.fromEntries(settings)).filter((text) => !ofEntries.has(text)),
    ...ofFields(materialAssetFields),
    ...views.map(englishViewLabel),
    ...below('packages/renderer/src/views').flatMap(([path, source]) => propertyTexts(path, source, 'label')),
    ...viewProblems(),
    ...below('packages/engine/src')
      .filter(([path]) => !ownFiles.has(path))
      .flatMap(([path, source]) => propertyTexts(path, source, 'help', 'label')),
    ...below('packages/renderer/src/renderer').flatMap(([path, source]) => propertyTexts(path, source, 'reason')),
    ...below('packages/renderer/src/renderer/budget')
      .filter(([path]) => path.endsWith('reasons.ts'))
      .flatMap(([path, source]) => Object.values(tableOf(path, source))),
    ...below('apps/editor/src/plugins').flatMap(([path, source]) =>
      propertyTexts(path, source, 'help', 'label', 'title'),
    ),
  ].filter(hasLetters);
}

/** English texts that lack a Spanish one: the list may only get shorter. See `languageGaps` for what need not be in it. */
const gaps: readonly string[] = [];

const placeholders = (text: string): string[] => (text.match(/\{\w+\}/g) ?? []).toSorted();

test('everything that the editor shows is there in Spanish but the gaps, and nothing that it does not show', () => {
  const [others, entries] = [otherTexts(), entryTexts()];
  const wanted = new Set([...others, ...Object.values(entries).flat()]);
  expect(wanted.size).toBeGreaterThan(600);
  expect(languageGaps(others, entries, es)).toEqual(gaps);
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

test('decimals have a point in Spanish too, as in fields and counts, see formatCount', () => {
  expect(Object.entries(es).filter(([, spanish]) => /\d,\d/.test(spanish))).toEqual([]);
});

test('whatever the editor shows is looked up in the language that is shown', () => {
  const faults = below('apps/editor/src', 'packages/editing/src', 'packages/attach/src').flatMap(
    ([path, source]) => textsOf(path, source).faults,
  );
  expect(faults).toEqual([]);
});

test('the attached editor, the viewer and the Lab have the same words', () => {
  const folders = ['packages/attach/src/language', 'apps/viewer/src/language', 'apps/lab/src/language'];
  const texts = below(...folders).flatMap(([path, source]) => Object.entries(tableOf(path, source)));
  expect(texts.length).toBeGreaterThan(250);
  expect(texts.filter(([english, spanish]) => Object.hasOwn(es, english) && es[english] !== spanish)).toEqual([]);
});

test('the language is the chosen one, else the first of the browser, else English', () => {
  expect(firstLanguage('en', ['es-MX'])).toBe('en');
  expect(firstLanguage(null, ['de-DE', 'es-419', 'en'])).toBe('es');
  expect(firstLanguage('klingon', ['fr'])).toBe('en');
  expect(firstLanguage(undefined, [])).toBe('en');
});
