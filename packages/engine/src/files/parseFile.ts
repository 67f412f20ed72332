import { shortText } from '@farol/editing';
import { type AssetType, describeValue } from '@farol/editing/fields';
import type { AssetLibrary } from '../assets/AssetLibrary';
import { fieldAssetFields, isFieldAssetType } from '../assets/fieldAssetTypes';
import { isFileAssetType } from '../assets/loadAsset';
import { builtinComponents } from '../components/index';
import type { ComponentRegistry } from '../core/ComponentRegistry';
import { pictureProblem, type ScenePicture } from '../core/ScenePicture';
import { sceneFields } from '../settings/SceneSettings';
import { assetUses, type AssetUse } from './assetUses';
import { checkDepth } from '../guard/checkDepth';
import { type FarolFile, FILE_VERSION, type FileAsset, type FileObject } from './FarolFile';
import { FileError } from '../guard/FileError';
import type { PathLike } from './FilePath';
import { isRecord, join, type JsonRecord, ProblemList } from './ProblemList';
import { readValues } from './readComponent';
import { readMicroShaders } from './readMicroShaders';
import { readViews } from './readViews';
import { migrateFile } from './migrateFile';
import { OwnAssets } from './OwnAssets';
import { readObjects } from './readObjects';
import { checkLinks, checkSizes, readPrefabs } from './readPrefabs';

/** Options of `parseFile`. */
export interface ParseOptions {
  /** Component types to read; the built-in ones when absent. */
  registry?: ComponentRegistry;
  /** Library that must have every asset that the file names and does not contain. Not checked when absent. */
  assets?: AssetLibrary;
}

function parseJson(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (cause) {
    // binary data get a message of their own, since the browser's would quote them
    const isBinary = /[\0-\b\ufffd]/.test(text.slice(0, 1000));
    const reason = isBinary ? 'it is not text' : shortText((cause as Error).message, 120);
    const problem = `is not JSON: ${reason}. Choose a scene that was saved by Farol.`;
    throw new FileError([{ path: '', problem: `The file ${problem}` }], { cause });
  }
}

function fail(path: string, problem: string): never {
  throw new FileError([{ path, problem }]);
}

function checkHead(file: unknown): JsonRecord {
  checkDepth(file);
  if (!isRecord(file)) return fail('', `The file must hold an object, not ${describeValue(file)}.`);
  if (file.format !== 'farol-scene') fail('format', `must be "farol-scene", not ${describeValue(file.format)}.`);
  const { version } = file;
  if (typeof version !== 'number' || !Number.isInteger(version) || version < 1) {
    fail('version', `must be a whole number of at least 1, not ${describeValue(version)}.`);
  } else if (version > FILE_VERSION) {
    fail('version', `is ${version}, but this Farol reads files up to version ${FILE_VERSION}: update Farol.`);
  }
  return file;
}

function readAssets(value: unknown, path: PathLike, problems: ProblemList): FileAsset[] {
  const names = new Set<string>();
  return problems.array(value, path).map((each, i) => {
    const at = join(path, i);
    const record = problems.record(each, at);
    problems.onlyKeys(record, at, ['name', 'type', 'url', 'file', 'values']);
    const name = problems.text(record.name, join(at, 'name'));
    if (names.has(name)) problems.add(join(at, 'name'), `'${shortText(name)}' is there twice. Remove one.`);
    names.add(name);
    const { type } = record;
    if (isFieldAssetType(type)) {
      const values = readValues(record.values ?? {}, fieldAssetFields[type], join(at, 'values'), problems);
      return { name, type, values };
    }
    if (typeof type !== 'string' || !isFileAssetType(type as AssetType)) {
      const known = '"mesh", "texture", "model", "material", "script", "clip", "sound", "surface", "profile" or "bake"';
      problems.add(join(at, 'type'), `must be ${known}, not ${describeValue(type)}.`);
    }
    const asset: FileAsset = { name, type: type as FileAsset['type'] };
    if (record.file !== undefined) asset.file = problems.text(record.file, join(at, 'file'));
    else asset.url = problems.text(record.url, join(at, 'url'));
    return asset;
  });
}

function readFolders(value: unknown, problems: ProblemList): string[] {
  return problems.array(value, 'assetFolders').map((each, i) => {
    const at = join('assetFolders', i);
    const path = problems.text(each, at);
    if (path && path.split('/').some((part) => part.trim() === ''))
      problems.add(at, `must be a path such as "Props/Lamps", not ${describeValue(path)}.`);
    return path;
  });
}

function readPicture(value: unknown, problems: ProblemList): ScenePicture {
  const record = problems.record(value, 'picture');
  problems.onlyKeys(record, 'picture', ['url', 'chosen']);
  const { url, chosen } = record;
  const problem = pictureProblem(url);
  if (problem !== null) problems.add(join('picture', 'url'), problem);
  if (chosen !== undefined && chosen !== true)
    problems.add(join('picture', 'chosen'), `must be true or absent, not ${describeValue(chosen)}.`);
  return { url: url as string, ...(chosen === true ? { chosen } : {}) };
}

function checkCamera(id: unknown, objects: readonly FileObject[], problems: ProblemList): string | null {
  if (id === null) return null;
  const camera = objects.find((object) => object.id === id)?.components.some(({ type }) => type === 'Camera');
  if (!camera)
    problems.add('activeCamera', `must be the id of an object with a Camera, or null, not ${describeValue(id)}.`);
  return id as string;
}

/**
 * Reads and checks a scene file, and brings older components up to date. Only copies the data; makes no objects.
 * @param input - JSON text, or parsed JSON
 * @throws FileError listing everything that is wrong: no JSON, another format, a newer version, unknown components and
 *   fields, newer component versions, values of another type or out of range, duplicate ids, missing parents, cycles,
 *   and, when `options.assets` is given, missing assets
 */
export function parseFile(input: unknown, options: ParseOptions = {}): FarolFile {
  const registry = options.registry ?? builtinComponents;
  const problems = new ProblemList();
  const file = readFile(input, registry, problems);
  if (options.assets) checkAssets(file, assetUses(file, registry), options.assets, problems);
  problems.throwIfAny();
  return file;
}

const headKeys = [
  ...['$schema', 'format', 'version', 'name', 'settings', 'activeCamera', 'assets', 'assetFolders', 'prefabs'],
  ...['microShaders', 'views', 'picture', 'objects'],
];

/**
 * First half of `parseFile`, without the search for missing assets.
 * @param problems - receives the problems
 * @throws FileError when the file cannot be read at all
 */
export function readFile(input: unknown, registry: ComponentRegistry, problems: ProblemList): FarolFile {
  const raw = migrateFile(checkHead(typeof input === 'string' ? parseJson(input) : input));
  problems.onlyKeys(raw, '', headKeys);
  if (raw.$schema !== undefined) problems.text(raw.$schema, '$schema', true);
  const prefabs = readPrefabs(raw.prefabs ?? [], 'prefabs', registry, problems);
  const objects = readObjects(raw.objects, 'objects', registry, problems);
  checkLinks(objects, 'objects', new Set(prefabs.map(({ id }) => id)), problems);
  checkSizes(prefabs, objects, 'prefabs', problems);
  return {
    format: 'farol-scene',
    version: FILE_VERSION,
    name: problems.text(raw.name, 'name', true),
    settings: readValues(raw.settings ?? {}, sceneFields, 'settings', problems),
    activeCamera: checkCamera(raw.activeCamera ?? null, objects, problems),
    assets: readAssets(raw.assets ?? [], 'assets', problems),
    ...(raw.assetFolders === undefined ? {} : { assetFolders: readFolders(raw.assetFolders, problems) }),
    ...(raw.microShaders === undefined
      ? {}
      : { microShaders: readMicroShaders(raw.microShaders, 'microShaders', problems) }),
    ...(raw.views === undefined ? {} : { views: readViews(raw.views, 'views', problems) }),
    ...(raw.picture === undefined ? {} : { picture: readPicture(raw.picture, problems) }),
    ...(prefabs.length > 0 ? { prefabs } : {}),
    objects,
  };
}

/** Uses of assets that neither the library nor the file contains. @param uses - all uses in the file */
export function missingAssets(file: FarolFile, uses: readonly AssetUse[], assets: AssetLibrary): AssetUse[] {
  const own = new OwnAssets(file.assets);
  return uses.filter((use) => !assets.has(use.name) && !own.mayHold(use));
}

/**
 * Checks that every asset that a file uses is in the library or in the file: the second half of `parseFile`.
 * @param uses - asset names in the file, each with its place
 */
export function checkAssets(
  file: FarolFile,
  uses: readonly AssetUse[],
  assets: AssetLibrary,
  problems: ProblemList,
): void {
  const own = new OwnAssets(file.assets);
  for (const use of uses) {
    if (problems.isFull) return;
    if (!assets.has(use.name) && own.mayHold(use)) continue;
    const problem = assets.problemWith(use.type, use.name);
    if (problem) problems.add(use.path, problem);
  }
}
