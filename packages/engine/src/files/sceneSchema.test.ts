import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { checkFieldValue, type Field, type FieldTable } from '@farol/editing/fields';
import { root } from '@farol/tools/root';
import { Ajv, type ErrorObject } from 'ajv';
import { describe, expect, it, test } from 'vitest';
import { fieldAssetFields } from '../assets/fieldAssetTypes';
import { createRandom } from '../base/createRandom';
import { builtinComponents } from '../components/index';
import { Scene } from '../core/Scene';
import { randomFieldValue } from '../fields/randomFieldValue';
import type { FileError, FileProblem } from '../guard/FileError';
import { sceneFields } from '../settings/SceneSettings';
import type { FarolFile } from './FarolFile';
import { parseFile } from './parseFile';
import { readSceneFile } from './readSceneFile';
import { sceneSchema, valuesSchema } from './sceneSchema';
import { serialize } from './serialize';

const ajv = new Ajv({
  allErrors: true,
  verbose: true,
  allowUnionTypes: true,
  strictTypes: false,
  strictRequired: false,
});
const validate = ajv.compile(sceneSchema());
const flaws = (file: unknown): ErrorObject[] => (validate(file) ? [] : [...validate.errors!]);

const samples = [
  ...readdirSync(join(root, 'public/scenes')).map((name) => `public/scenes/${name}`),
  'packages/create-farol/templates/scene/public/scene.json',
];

test.each(samples)('%s is valid by the schema', async (path) => {
  const { text } = await readSceneFile(readFileSync(join(root, path)));
  expect(flaws(JSON.parse(text))).toEqual([]);
});

it('finds a scene that is saved valid, and lets a file name its schema', () => {
  const saved = JSON.parse(JSON.stringify(serialize(new Scene())));
  const named = { $schema: './scene.schema.json', ...saved };
  expect([flaws(saved), flaws(named)]).toEqual([[], []]);
  expect(parseFile(named)).toEqual(parseFile(saved));
  expect(() => parseFile({ ...saved, $schema: 3 })).toThrow('$schema must be text, not 3.');
});

it('is one with the reader where a component has no values', () => {
  const component = { type: 'Light', version: 1, id: 'l', values: null };
  const file = {
    ...{ format: 'farol-scene', version: 3, name: '' },
    objects: [{ id: 'a', name: 'A', parent: null, components: [component] }],
  };
  expect(flaws(file)).not.toEqual([]);
  expect(() => parseFile(file)).toThrow('objects[0].components[0].values must be an object, not null.');
});

/** Values that most fields do not allow. */
const strange = [null, true, -1, 0.5, 1e9, '', 'x', [], {}, [1, 2, 3], [-1, 0, 1e9], [[0, 1]], [[2, 1]]];
const tables: [string, FieldTable][] = [
  ['settings', sceneFields],
  ...Object.entries(fieldAssetFields),
  ...[...builtinComponents.types].map(([name, { fields }]): [string, FieldTable] => [name, fields]),
];

describe.each(tables)('%s', (_name, fields) => {
  const random = createRandom(31);
  const check = ajv.compile(valuesSchema(fields, ''));

  test.each(Object.entries(fields))('%s has one check in schema and fields', (name, field: Field) => {
    const allowed = Array.from({ length: 8 }, () => randomFieldValue(field, random, ['a']));
    for (const value of [...allowed, field.default, ...strange]) {
      const isAllowed = checkFieldValue(field, value) === null;
      const isValid = check({ [name]: value });
      // only its own check knows the values that a custom field allows
      if (field.kind === 'custom') expect(isAllowed && !isValid, JSON.stringify(value)).toBe(false);
      else expect(isValid, JSON.stringify(value)).toBe(isAllowed);
    }
  });
});

/** A file with every part that files can have. */
function wholeFile(): FarolFile {
  const random = createRandom(7);
  const valuesOf = (fields: FieldTable) =>
    Object.fromEntries(Object.entries(fields).map(([name, field]) => [name, randomFieldValue(field, random)]));
  const object = (id: string, parent: string | null, more = {}) => ({ id, name: id, parent, components: [], ...more });
  return {
    ...{ format: 'farol-scene', version: 3, name: 'All', activeCamera: 'Camera', settings: valuesOf(sceneFields) },
    assets: [
      ...Object.entries(fieldAssetFields).map(([type, fields]) => ({ name: type, type, values: valuesOf(fields) })),
      { name: 'a.png', type: 'texture', url: 'data:,' },
      { name: 'b.glb', type: 'model', file: 'assets/b.glb' },
    ] as FarolFile['assets'],
    assetFolders: ['Props/Lamps'],
    microShaders: { own: 'float own() { return 1.0; }' },
    picture: { url: 'data:image/webp;base64,UklGRg==', chosen: true },
    views: [{ place: 1, name: 'Door', position: [0, 1, 2], target: [0, 0, 0], fov: 1, orthographic: false }],
    prefabs: [{ id: 'lamp', name: 'Lamp', objects: [object('lamp', null), object('bulb', 'lamp', { locked: true })] }],
    objects: [
      object('copy', null, { prefab: { prefab: 'lamp', source: 'lamp', pinned: ['name'] }, tags: ['far'] }),
      ...[...builtinComponents.types].map(([type, { version, fields }]) =>
        object(type, null, {
          ...{ active: false, static: true },
          components: [{ type, version, id: `${type}-1`, enabled: false, values: valuesOf(fields) }],
        }),
      ),
    ],
  };
}

type Path = readonly (string | number)[];

/** Paths of all values below a value. */
function paths(value: unknown, above: Path = []): Path[] {
  if (typeof value !== 'object' || value === null) return [];
  const keys = Array.isArray(value) ? [...value.keys()] : Object.keys(value);
  return keys.flatMap((key) => [
    [...above, key],
    ...paths((value as Record<string | number, unknown>)[key], [...above, key]),
  ]);
}

const pathText = (path: string): string =>
  path
    .split('/')
    .slice(1)
    .map((part) => (/^\d+$/.test(part) ? `[${part}]` : `.${part}`))
    .join('')
    .replace(/^\./, '');

/** Words of messages for each type of the schema. */
const typeWords: Readonly<Record<string, RegExp>> = {
  object: /an object/,
  array: /a list|\[|keys/,
  string: /text|name of|id of|as "data:/,
  boolean: /true or false/,
  number: /number|angle|\[|keys/,
  integer: /whole number/,
};

/** Expected path and message of an error of the schema. */
function demand({ keyword, instancePath, params, schema, parentSchema }: ErrorObject): [string, (string | RegExp)[]] {
  const at = pathText(instancePath);
  const member = (name: string): string => (at ? `${at}.${name}` : name);
  switch (keyword) {
    case 'additionalProperties': {
      // messages are cut after 400 characters
      const known = Object.keys((parentSchema as { properties: object }).properties);
      return [member(params.additionalProperty), known.slice(0, 8)];
    }
    case 'required':
      return [member(params.missingProperty), [/^must/]];
    case 'enum':
      return [at, (schema as string[]).map((option) => JSON.stringify(option))];
    case 'const':
      return [at, [JSON.stringify(schema)]];
    case 'minimum':
    case 'maximum':
      return [at, [String(schema)]];
    case 'type':
      return [at, ([schema].flat() as string[]).flatMap((type) => typeWords[type] ?? [])];
    default:
      return [at, []];
  }
}

const isSaid = ([place, words]: ReturnType<typeof demand>, problems: readonly FileProblem[]): boolean =>
  problems.some(
    ({ path, problem }) =>
      // a component without a type is not read further
      path === place.replace(/\.\w+$/, '.type') ||
      ((place === path || place.startsWith(`${path}[`) || path.startsWith(`${place}.`)) &&
        words.every((word) => (typeof word === 'string' ? problem.includes(word) : word.test(problem)))),
  );

describe('a file in which one value is wrong', () => {
  const whole = wholeFile();
  const all = paths(whole);
  const ways = [all.filter((path) => !path.includes('values') && path[0] !== 'settings'), all];
  const random = createRandom(131);
  const pick = <T>(from: readonly T[]): T => from[Math.floor(random() * from.length)];

  it('is valid before', () => {
    expect(flaws(whole)).toEqual([]);
    expect(parseFile(whole).objects).toHaveLength(whole.objects.length);
  });

  it('is refused by the reader in the words of the schema', () => {
    let refused = 0;
    for (let i = 0; i < 500; i++) {
      const file = structuredClone(whole) as unknown as Record<string | number, never>;
      const path = pick(ways[i % 2]);
      let holder = file;
      for (const key of path.slice(0, -1)) holder = holder[key];
      const key = path.at(-1)!;
      const kind = Math.floor(random() * 5);
      if (kind === 0 && !Array.isArray(holder)) delete holder[key];
      else if (kind === 1 && !Array.isArray(holder)) holder.other = 1 as never;
      else holder[key] = pick(strange) as never;

      let problems: readonly FileProblem[] = [];
      try {
        parseFile(file);
      } catch (error) {
        problems = (error as FileError).problems;
      }
      // all failed alternatives are reported
      const found = flaws(file).filter(({ keyword, schemaPath }) => keyword !== 'if' && !/\/anyOf/.test(schemaPath));
      if (found.length > 0) refused++;
      const unsaid = found.map(demand).filter((each) => !isSaid(each, problems));
      expect(
        unsaid,
        `${path.join('/')}\n${JSON.stringify(holder)?.slice(0, 300)}\n${JSON.stringify(problems)}`,
      ).toEqual([]);
    }
    expect(refused).toBeGreaterThan(150);
  });
});
