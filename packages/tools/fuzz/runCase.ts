import { parseMicroShader, parseMicroShaderXML } from '@farol/renderer/authoring';
import type { Light } from 'three';
import { AssetLibrary } from '../../engine/src/assets/AssetLibrary';
import { readModel } from '../../engine/src/assets/readModel';
import { GameObject } from '../../engine/src/core/GameObject';
import { Scene } from '../../engine/src/core/Scene';
import { readSceneFile, type SceneFile } from '../../engine/src/files/readSceneFile';
import { deserialize } from '../../engine/src/files/deserialize';
import { FileError } from '../../engine/src/guard/FileError';
import { serialize } from '../../engine/src/files/serialize';
import { unpack } from '../../engine/src/guard/unpack';
import { parsePly } from '../../engine/src/geometry/parsePly';
import { CaseMeter, collectGarbage, youngBytes } from './CaseMeter';
import { machineSlowness } from '@farol/tools/machineSlowness';
import type { FuzzCase } from './generate';

/** Time and memory that a case may take. */
export interface FuzzBudget {
  /** Seconds on the reference machine of `machineSlowness`; a machine that is slower or busy gets more by its factor. */
  readonly seconds: number;
  /** Bytes of memory that a case of a size (bytes) may take. */
  memory(bytes: number): number;
}

export const fuzzBudget: FuzzBudget = { seconds: 2, memory: (bytes) => 4 * bytes + 64 * 2 ** 20 };

export interface FuzzResult {
  /** Fault of the case; null when there is none. */
  readonly failure: string | null;
  readonly isTaken: boolean;
  /** Time of opening and saving the case, or of opening and saving the saved file: the longer one. */
  readonly seconds: number;
  /** Memory that the case took (bytes). */
  readonly memory: number;
}

/** Names on the prototypes that all objects share, which no file may change. */
const prototypes = (): string =>
  [Object, Array, String, Function, Map].map((each) => Reflect.ownKeys(each.prototype).map(String).join()).join(';');

// oxlint-disable-next-line no-control-regex -- these must not come into a message
const UNPRINTABLE = /[\u0000-\u0009\u000b-\u001f\u007f-\u009f\u202a-\u202e]/;
const RAW =
  /Cannot (read|set|destructure|convert)|is not (a function|iterable|defined|a constructor)|undefined|call stack/;

const text = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

/** The scene that is open, and its library: both must be as before when a file was refused. */
class OpenScene {
  readonly assets = new AssetLibrary({
    fetchBytes: (url) => Promise.reject(new Error(`${url.slice(0, 40)} answered 404`)),
  });
  readonly scene = new Scene({ name: 'Open', assets: this.assets });
  private readonly before: string;

  constructor() {
    const object = new GameObject('Lamp', { id: 'open' });
    object.addComponent('Light');
    object.addComponent('ObjectRenderer');
    this.scene.add(object);
    this.before = this.state();
  }

  /** A sentence if the open scene or its assets have changed; null if not. */
  change(): string | null {
    return this.state() === this.before ? null : 'the open scene, or its assets, are not as before';
  }

  private state(): string {
    const { assets, scene } = this;
    return JSON.stringify([
      serialize(scene),
      scene.three.children.length,
      assets.list(),
      assets.uses.size,
      assets.materials.size,
    ]);
  }
}

async function openScene({ kind, bytes }: FuzzCase, open: OpenScene): Promise<Scene> {
  let file: SceneFile = { text: '', fileOf: () => null };
  if (kind === 'zip') file = await readSceneFile(bytes);
  else if (kind === 'link') {
    try {
      file = { ...file, text: text(await unpack(bytes, 'deflate-raw')) };
    } catch (error) {
      if (error instanceof FileError) throw error;
      throw new FileError([{ path: '', problem: 'The link is damaged.' }]);
    }
  } else file = { ...file, text: text(bytes) };
  return deserialize(file.text, { assets: open.assets, fileOf: file.fileOf });
}

/**
 * Checks a scene that was opened.
 * @param measure - called before the saved scene is opened as a second scene, to measure the first one alone
 * @returns its fault; null when there is none
 */
async function checkScene(scene: Scene, open: OpenScene, measure: () => void): Promise<string | null> {
  scene.update(1 / 60);
  scene.three.updateMatrixWorld();
  const lights: Light[] = [];
  scene.three.traverse((object) => 'isLight' in object && lights.push(object as Light));
  scene.reset();
  const saved = JSON.stringify(serialize(scene));
  measure();
  const copy = await deserialize(saved, { assets: open.assets });
  const again = JSON.stringify(serialize(copy));
  copy.dispose();
  return again === saved ? null : `it does not save to itself: ${differ(saved, again)}`;
}

function differ(a: string, b: string): string {
  let at = 0;
  while (a[at] === b[at]) at++;
  return `${a.slice(at - 40, at + 60)} | ${b.slice(at - 40, at + 60)}`;
}

/** @param measure - called once the file is open, before `checkScene` makes a second scene */
async function open(given: FuzzCase, other: OpenScene, measure: () => void): Promise<string | null> {
  const { kind, bytes } = given;
  if (kind === 'xml') void parseMicroShaderXML(text(bytes), 'fuzz.xml');
  else if (kind === 'glsl') void parseMicroShader('fuzz', text(bytes));
  else if (kind === 'ply') (await parsePly(bytes.slice().buffer)).dispose();
  else if (kind === 'glb') {
    const model = await readModel(bytes.slice().buffer);
    model.scene.updateMatrixWorld(true);
    model.dispose();
  } else {
    const scene = await openScene(given, other);
    const failure = await checkScene(scene, other, measure);
    scene.dispose();
    return failure;
  }
  measure();
  return null;
}

function errorFailure({ kind }: FuzzCase, error: unknown): string | null {
  if (!(error instanceof Error)) return `threw ${String(error)}`;
  const { message, name } = error;
  const isScene = kind === 'scene' || kind === 'zip' || kind === 'link';
  if (isScene && !(error instanceof FileError)) return `${name}: ${message}\n${error.stack}`;
  if (message.length >= 2000) return `a message of ${message.length} letters`;
  if (UNPRINTABLE.test(message)) return `raw bytes in: ${JSON.stringify(message)}`;
  if (!isScene && (name !== 'Error' || RAW.test(message))) return `${name}: ${message}\n${error.stack}`;
  return null;
}

/** @param collect - see `CaseMeter.begin` */
async function runOnce(
  given: FuzzCase,
  budget: FuzzBudget,
  collect: (() => void) | null,
): Promise<FuzzResult & { isBlurred: boolean }> {
  const other = new OpenScene();
  const shapes = prototypes();
  const meter = await CaseMeter.begin(collect);
  let failure: string | null = null;
  let isTaken = false;
  try {
    failure = await open(given, other, () => meter.lap());
    isTaken = true;
  } catch (error) {
    failure = errorFailure(given, error) ?? other.change();
  }
  meter.lap();
  const { seconds, memory, isBlurred } = meter;
  if (prototypes() !== shapes) failure ??= 'a prototype was changed';
  if (seconds > budget.seconds) {
    const allowed = budget.seconds * machineSlowness();
    if (seconds > allowed) failure ??= `${seconds.toFixed(1)} s (${allowed.toFixed(1)} allowed on this machine now)`;
  }
  if (memory > budget.memory(given.bytes.length)) failure ??= `${Math.round(memory / 2 ** 20)} MB`;
  other.scene.dispose();
  other.assets.dispose();
  return { failure, isTaken, seconds, memory, isBlurred };
}

/**
 * Opens a case as a user would, and checks the result. The first run counts garbage as memory, its own and that of
 * earlier cases. If its time or memory is over the limit, or its memory near it or not known (`isBlurred`), a second
 * run with garbage collected before and after decides. Any other failure counts at once.
 */
export async function runCase(given: FuzzCase, budget = fuzzBudget): Promise<FuzzResult> {
  const { isBlurred, ...result } = await runOnce(given, budget, null);
  const { failure, seconds, memory } = result;
  const isCheap = seconds <= budget.seconds && memory + youngBytes <= budget.memory(given.bytes.length);
  if ((isCheap && !isBlurred) || (failure !== null && !/^[\d.]+ (s|MB)\b/.test(failure))) return result;
  const { failure: again, isTaken, seconds: longer, memory: kept } = await runOnce(given, budget, collectGarbage);
  return { failure: again, isTaken, seconds: longer, memory: kept };
}
