import { allowedBy, type Field, type FieldTable, MOST_KEYS } from '@farol/editing/fields';
import { fieldAssetFields } from '../assets/fieldAssetTypes';
import { builtinComponents } from '../components/index';
import { LONGEST_PICTURE } from '../core/ScenePicture';
import { MOST_VIEWS, type SceneView } from '../core/SceneViews';
import { sceneFields } from '../settings/SceneSettings';
import {
  type FarolFile,
  FILE_VERSION,
  type FileAsset,
  type FileComponent,
  type FileObject,
  type FileView,
  type Prefab,
  type PrefabLink,
} from './FarolFile';

/** A JSON schema of draft 7, the version that code editors support. */
export interface JsonSchema {
  readonly [keyword: string]: unknown;
}

const text = (description: string): JsonSchema => ({ type: 'string', description });
const filled = (description: string): JsonSchema => ({ type: 'string', minLength: 1, description });
const flag = (description: string, whenAbsent: boolean): JsonSchema => ({
  ...{ type: 'boolean', default: whenAbsent, description },
});
const list = (items: JsonSchema, description: string, more: JsonSchema = {}): JsonSchema => ({
  ...{ type: 'array', items, description, ...more },
});
const triple = (items: JsonSchema): JsonSchema => ({ type: 'array', items, minItems: 3, maxItems: 3 });
const keys = (...items: JsonSchema[]): JsonSchema => ({
  type: 'array',
  items: { type: 'array', items, minItems: items.length, maxItems: items.length },
  minItems: 1,
  maxItems: MOST_KEYS,
});
const ref = (name: string): JsonSchema => ({ $ref: `#/definitions/${name}` });
const record = (properties: Readonly<Record<string, JsonSchema>>, description: string, required: string[] = []) => ({
  ...{ type: 'object', properties, required, additionalProperties: false, description },
});

/** Schema of a part that may be null as well as absent. */
const orNull = (schema: JsonSchema): JsonSchema => ({ ...schema, type: [schema.type, 'null'] });

const number = { type: 'number' };
const share = { type: 'number', minimum: 0, maximum: 1 };
const colour = triple({ type: 'number', minimum: 0 });
const nameOrNull = { type: ['string', 'null'], minLength: 1 };
/** Schema of a field value of an unknown component. */
const anyValue = {
  anyOf: [
    { type: ['number', 'string', 'boolean', 'null'] },
    triple(number),
    keys(share, number),
    keys(share, { anyOf: [colour, { type: 'null' }] }, { type: ['number', 'null'], minimum: 0, maximum: 1 }),
  ],
};

/** Schema of a field's values. Rules beyond JSON schema (ascending times of keys) are in the description. */
function valueSchema(field: Field): JsonSchema {
  const range = {
    ...('min' in field && field.min !== undefined ? { minimum: field.min } : {}),
    ...('max' in field && field.max !== undefined ? { maximum: field.max } : {}),
  };
  switch (field.kind) {
    case 'number':
      return { type: field.integer ? 'integer' : 'number', ...range };
    case 'angle':
      return { type: 'number', ...range };
    case 'boolean':
    case 'string':
      return { type: field.kind };
    case 'choice':
      return { enum: field.options };
    case 'vector3':
      return triple({ type: 'number', ...range });
    case 'euler':
      return triple(number);
    case 'colour':
      return colour;
    case 'curve':
      return keys(share, { type: 'number', ...range });
    case 'gradient':
      return anyValue.anyOf[3];
    case 'asset':
    case 'object':
      return nameOrNull;
    case 'custom':
      return anyValue;
  }
}

/** Schema of the values of a table of fields, described as in the messages of the reader. */
export const valuesSchema = (fields: FieldTable, description: string): JsonSchema =>
  record(
    Object.fromEntries(
      Object.entries(fields).map(([name, field]) => [
        name,
        {
          ...valueSchema(field),
          ...{ default: field.default, description: `${field.help} Must be ${allowedBy(field)}.` },
          ...(field.deprecated ? { deprecated: true } : {}),
        },
      ]),
    ),
    description,
  );

/** A schema that applies where a condition holds, and another where it does not. */
const ifThen = (condition: JsonSchema, schema: JsonSchema, otherwise: JsonSchema = {}): JsonSchema => ({
  // oxlint-disable-next-line unicorn/no-thenable -- a keyword of JSON schema
  ...{ if: condition, then: schema, else: otherwise },
});
/** A schema that applies where members of an object have certain values. */
const whenMembers = (members: JsonSchema, schema: JsonSchema): JsonSchema =>
  ifThen({ properties: members, required: Object.keys(members) }, schema);

const link = record(
  {
    prefab: filled('Id of the prefab.'),
    source: filled("Id of the object in the prefab; the prefab's own id for the root of an instance."),
    pinned: list(filled('A name such as "Light.intensity".'), "Overrides that have the prefab's present value."),
  } satisfies Record<keyof PrefabLink, JsonSchema>,
  'Object of a prefab that this one is a copy of.',
  ['prefab', 'source'],
);

const object = record(
  {
    id: filled('Distinct in the file.'),
    name: text('Name in the tree.'),
    parent: { ...nameOrNull, description: 'Id of the object above; null at the top.' },
    active: flag('Whether the object and those below it are there.', true),
    locked: flag('Whether editors leave it out of picking.', false),
    static: flag('Whether it stays where it is, and takes part in a bake.', false),
    tags: list(filled('A tag.'), 'Words by which scripts find objects.'),
    prefab: link,
    components: list(ref('component'), 'Components, the Transform first.'),
  } satisfies Record<keyof FileObject, JsonSchema>,
  'An object of the scene.',
  ['id', 'name', 'parent', 'components'],
);

const component = (): JsonSchema => ({
  ...record(
    {
      type: { ...filled('Type of the component.'), examples: [...builtinComponents.types.keys()] },
      version: { type: 'integer', minimum: 1, description: 'Version of the class that wrote the values.' },
      id: filled('Distinct in the file.'),
      enabled: flag('Whether the component has its effect.', true),
      values: { type: 'object', additionalProperties: anyValue, description: 'Values other than the defaults.' },
    } satisfies Record<keyof FileComponent, JsonSchema>,
    'A component of an object: one of the engine, of a script or of a plugin.',
    ['type', 'version', 'id', 'values'],
  ),
  allOf: [...builtinComponents.types].flatMap(([name, { version }]) => [
    whenMembers({ type: { const: name } }, { properties: { version: { maximum: version } } }),
    whenMembers({ type: { const: name }, version: { const: version } }, { properties: { values: ref(name) } }),
  ]),
});

const madeOfFields = Object.keys(fieldAssetFields);
const readFromFiles = ['mesh', 'texture', 'model', 'sound', 'profile', 'bake'];

const asset: JsonSchema = {
  ...record(
    {
      name: filled("Name with its folder, such as 'Props/robot.glb'."),
      type: { enum: [...madeOfFields, ...readFromFiles], description: 'Kind of asset.' },
      url: { description: 'Address of its file; a data: address contains the bytes.' },
      file: { description: "Path of its file in the .farol container, such as 'assets/robot.glb'." },
      values: { description: 'Values of a material, script, clip or surface other than the defaults.' },
    } satisfies Record<keyof FileAsset, JsonSchema>,
    'An asset of the scene: of an address, a file of the container, or fields.',
    ['name', 'type'],
  ),
  allOf: [
    ...madeOfFields.map((type) =>
      whenMembers({ type: { const: type } }, { properties: { values: ref(`${type}Asset`) } }),
    ),
    whenMembers(
      { type: { enum: readFromFiles } },
      ifThen(
        { required: ['file'] },
        { properties: { file: filled('A path.') } },
        { properties: { url: filled('An address.') }, required: ['url'] },
      ),
    ),
  ],
};

const viewMembers: Record<keyof SceneView, JsonSchema> = {
  name: text('Name of the view.'),
  position: { ...triple(number), description: 'Place of the eye (m).' },
  target: { ...triple(number), description: 'Point that is looked at (m); elsewhere than the eye.' },
  fov: { type: 'number', minimum: 0.01, maximum: 3.1, description: 'Vertical field of view (rad).' },
  orthographic: { type: 'boolean', description: 'Whether far things are as large as near ones.' },
};
const view = record(
  {
    place: { type: 'integer', minimum: 1, maximum: MOST_VIEWS, description: 'Distinct in the file.' },
    ...viewMembers,
  } satisfies Record<keyof FileView, JsonSchema>,
  'A camera bookmark of editors.',
  ['place', ...Object.keys(viewMembers)],
);

const prefab = record(
  {
    id: filled('Distinct in the file; the id of its first object too.'),
    name: text('Name of the prefab.'),
    objects: list(ref('object'), 'A tree of objects, the root first.'),
  } satisfies Record<keyof Prefab, JsonSchema>,
  'A tree of objects to be placed any number of times.',
  ['id', 'name', 'objects'],
);

/**
 * JSON schema of scene files, made from the same tables of fields that the reader uses. The package contains it as
 * `@farol/engine/scene.schema.json`. Every file that `parseFile` accepts is valid; ids, references and cycles are not
 * checked.
 */
export const sceneSchema = (): JsonSchema => ({
  $schema: 'http://json-schema.org/draft-07/schema#',
  title: 'Scene of Farol',
  ...record(
    {
      $schema: text('Address of this schema, for code editors.'),
      format: { const: 'farol-scene' },
      version: { type: 'integer', minimum: 1, maximum: FILE_VERSION, description: 'Version of the file format.' },
      name: text('Name of the scene.'),
      settings: ref('settings'),
      activeCamera: { type: ['string', 'null'], description: 'Id of the object whose Camera is looked through.' },
      assets: orNull(list(asset, 'Assets of the scene.')),
      assetFolders: list(
        { type: 'string', pattern: '^[^/]*[^/\\s][^/]*(/[^/]*[^/\\s][^/]*)*$' },
        "Folders of assets, such as 'Props/Lamps'.",
      ),
      prefabs: orNull(list(prefab, 'Prefabs of the scene.')),
      microShaders: {
        ...{ type: 'object', additionalProperties: { type: 'string' } },
        description: 'Texts of microshaders by name, in the form of a .glsl file.',
      },
      views: list(view, 'Camera bookmarks of editors.'),
      picture: record(
        {
          url: {
            ...{ type: 'string', pattern: '^data:image/(webp|jpeg|png);base64,[A-Za-z0-9_+/]+=*$' },
            ...{ maxLength: LONGEST_PICTURE, description: 'The picture as a data: address.' },
          },
          chosen: { const: true, description: 'Whether the user chose the view: saving keeps it.' },
        },
        'Small picture of the scene, by which lists of files show it.',
        ['url'],
      ),
      objects: list(ref('object'), 'Objects in the order of the tree.'),
    } satisfies Record<keyof FarolFile | '$schema', JsonSchema>,
    `A scene as Farol saves it, version ${FILE_VERSION}.`,
    ['format', 'version', 'name', 'objects'],
  ),
  definitions: {
    object,
    component: component(),
    settings: orNull(valuesSchema(sceneFields, 'Settings of the scene other than the defaults.')),
    ...Object.fromEntries(
      Object.entries(fieldAssetFields).map(([type, fields]) => [
        `${type}Asset`,
        orNull(valuesSchema(fields, `Values of a ${type} other than the defaults.`)),
      ]),
    ),
    ...Object.fromEntries(
      [...builtinComponents.types].map(([name, { fields, help }]) => [name, valuesSchema(fields, help)]),
    ),
  },
});
