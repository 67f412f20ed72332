import { parseMicroShader } from '@farol/renderer';
import { parseMicroShaderXML } from '@farol/renderer/authoring';
import type { Light } from 'three';
import { AssetLibrary } from '../assets/AssetLibrary';
import { readModel } from '../assets/readModel';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { readSceneFile, type SceneFile } from '../files/readSceneFile';
import { deserialize } from '../files/deserialize';
import { FileError } from '../files/FileError';
import { serialize } from '../files/serialize';
import { unpack } from '../files/unpack';
import { parsePly } from '../geometry/parsePly';
import type { FuzzCase } from './generate';

/** Seconds, and bytes of memory for those of the case, that one may take. */
export const fuzzBudget = { seconds: 2, memory: (bytes: number): number => 4 * bytes + 64 * 2 ** 20 };

export interface FuzzResult {
  /** What is wrong; null when all is well. */
  readonly failure: string | null;
  readonly isTaken: boolean;
  /** What opening it, saving it and opening what it was saved to took. */
  readonly seconds: number;
  /** Bytes. */
  readonly memory: number;
}

/** What must be as before: all that every object has. */
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

  /** What has changed; null when nothing has. */
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

/** What is wrong with a scene that was opened. @param measure - called while the scene is all there is of the case; from then on it is another file that is opened */
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

/** @param measure - called when the memory is taken that the case needs; a second scene for the check is none of it */
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

const used = (): number => {
  const { heapUsed, arrayBuffers } = process.memoryUsage();
  return heapUsed + arrayBuffers;
};

/** Measures what one file costs at a time. */
class Meter {
  /** Of all files. */
  seconds = 0;
  /** Bytes that the first file took. */
  memory = 0;
  private isFirst = true;
  private readonly before: number;
  private start = performance.now();
  private work = process.cpuUsage();

  constructor(private readonly collect: () => void) {
    collect();
    this.before = used();
    this.restart();
  }

  /** Ends the time of a file. What collecting garbage by force takes is none of it. */
  lap(): void {
    const { user, system } = process.cpuUsage(this.work);
    // neither what other processes took of the machine, nor threads that worked at once
    this.seconds += Math.min((performance.now() - this.start) / 1e3, (user + system) / 1e6);
    if (this.isFirst) {
      this.collect();
      this.memory = used() - this.before;
    }
    this.isFirst = false;
    this.restart();
  }

  private restart(): void {
    this.start = performance.now();
    this.work = process.cpuUsage();
  }
}

/**
 * Opens a case as a user would, and checks what came of it.
 * @param collect collects garbage, so that only memory in use is measured. Default: garbage counts, too
 */
export async function runCase(given: FuzzCase, collect: () => void = () => {}): Promise<FuzzResult> {
  const other = new OpenScene();
  const shapes = prototypes();
  const meter = new Meter(collect);
  let failure: string | null = null;
  let isTaken = false;
  try {
    failure = await open(given, other, () => meter.lap());
    isTaken = true;
  } catch (error) {
    failure = errorFailure(given, error) ?? other.change();
  }
  meter.lap();
  const { seconds, memory } = meter;
  if (prototypes() !== shapes) failure ??= 'a prototype was changed';
  if (seconds > fuzzBudget.seconds) failure ??= `${seconds.toFixed(1)} s`;
  if (memory > fuzzBudget.memory(given.bytes.length)) failure ??= `${Math.round(memory / 2 ** 20)} MB`;
  other.scene.dispose();
  other.assets.dispose();
  return { failure, isTaken, seconds, memory };
}
