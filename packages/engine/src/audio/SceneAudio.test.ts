import { readFileSync } from 'node:fs';
import { AudioContext as ThreeAudioContext, Vector3 } from 'three';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import '../components/index';
import { AudioListener } from '../components/AudioListener';
import { AudioSource } from '../components/AudioSource';
import { Camera } from '../components/Camera';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { audioOutput } from './audioOutput';

/** An AudioParam that takes each value at once. */
class Param {
  value = 0;
  setTargetAtTime(value: number): void {
    this.value = value;
  }
  linearRampToValueAtTime(value: number): void {
    this.value = value;
  }
}

const xyz = (name: string): Record<string, Param> =>
  Object.fromEntries(['X', 'Y', 'Z'].map((axis) => [name + axis, new Param()]));

interface FakeSource {
  readonly offset: number;
  readonly playbackRate: Param;
  loop: boolean;
  isRunning: boolean;
  onended?: (() => void) | null;
}

let begun: FakeSource[] = [];
let contexts = 0;
/** Values of a PannerNode that a source's fields set. */
interface FakePanner {
  readonly distanceModel: string;
  readonly refDistance: number;
  readonly maxDistance: number;
  readonly rolloffFactor: number;
}

let panners: (Record<string, Param> & FakePanner)[] = [];
let gains: { gain: Param }[] = [];

class FakeContext {
  state = 'running';
  currentTime = 0;
  destination = {};
  listener = { ...xyz('position'), ...xyz('forward'), ...xyz('up') };
  constructor() {
    contexts++;
  }
  createGain() {
    const node = { gain: new Param(), connect() {}, disconnect() {} };
    gains.push(node);
    return node;
  }
  createPanner() {
    const node = { ...xyz('position'), ...xyz('orientation'), connect() {}, disconnect() {} };
    panners.push(node as never);
    return node;
  }
  createBufferSource() {
    const node = {
      offset: 0,
      loop: false,
      isRunning: false,
      playbackRate: new Param(),
      connect() {},
      disconnect() {},
      start(_when: number, offset: number) {
        Object.assign(node, { offset, isRunning: true });
      },
      stop() {
        node.isRunning = false;
      },
    };
    begun.push(node);
    return node;
  }
}

const wav = readFileSync(new URL('../../../../public/sounds/thud.wav', import.meta.url));
const errors: string[] = [];
let activation: { hasBeenActive: boolean };
let scene: Scene;

/** Waits until the sound is decoded. */
const settle = () => vi.waitFor(() => expect(scene.assets.sound('thud.wav').buffer).not.toBeNull());

async function makeScene(values = {}): Promise<AudioSource> {
  scene = new Scene();
  scene.onComponentError = (_component, error) => errors.push((error as Error).message);
  scene.assets.registerFile('thud.wav', new Blob([wav]));
  await scene.assets.load('thud.wav');
  const object = new GameObject('Bell');
  const source = object.addComponent(AudioSource, { sound: 'thud.wav', ...values });
  scene.add(object);
  scene.update(0.1);
  await import('./SceneAudio');
  await Promise.resolve();
  return source;
}

function frames(count: number): void {
  for (let i = 0; i < count; i++) {
    scene.three.updateMatrixWorld();
    scene.update(0.1);
  }
}

beforeEach(() => {
  begun = [];
  panners = [];
  gains = [];
  contexts = 0;
  errors.length = 0;
  activation = { hasBeenActive: true };
  vi.stubGlobal('navigator', { userActivation: activation });
  vi.stubGlobal('window', globalThis);
  vi.stubGlobal('AudioContext', FakeContext);
  vi.stubGlobal(
    'OfflineAudioContext',
    class {
      decodeAudioData(bytes: ArrayBuffer): Promise<AudioBuffer> {
        const isWav = String.fromCharCode(...new Uint8Array(bytes, 0, 4)) === 'RIFF';
        return isWav ? Promise.resolve({ duration: 2 } as AudioBuffer) : Promise.reject(new Error('no'));
      }
    },
  );
  ThreeAudioContext.setContext(undefined as never);
});

afterEach(() => {
  scene.dispose();
  vi.unstubAllGlobals();
  audioOutput.muted = false;
});

test('without Web Audio nothing is heard, and nothing fails', async () => {
  vi.stubGlobal('AudioContext', undefined);
  vi.stubGlobal('OfflineAudioContext', undefined);
  const source = await makeScene();
  frames(3);
  expect(await scene.assets.sound('thud.wav').decode()).toBeNull();
  frames(3);
  expect([source.isPlaying, audioOutput.isWaiting]).toEqual([true, false]);
  expect(source.position).toBeCloseTo(0.6, 6);
  source.pause();
  frames(3);
  expect(source.position).toBeCloseTo(0.6, 6);
  source.play();
  frames(1);
  expect(source.position).toBeCloseTo(0.7, 6);
  scene.reset();
  expect([source.isPlaying, errors]).toEqual([false, []]);
});

test('plays on start from where the object is, ends, and makes no context before', async () => {
  const source = await makeScene({ playOnStart: false, maxDistance: 8, volume: 0.5 });
  source.gameObject.transform.position = [3, 0, -1];
  frames(2);
  expect([contexts, begun.length]).toEqual([0, 0]);
  source.play();
  frames(1);
  await settle();
  frames(2);
  expect([contexts, begun.length, begun[0].isRunning]).toEqual([1, 1, true]);
  const [panner] = panners;
  expect([panner.positionX.value, panner.positionZ.value, panner.distanceModel]).toEqual([3, -1, 'linear']);
  expect(panner.maxDistance).toBe(8);
  frames(20);
  expect([source.isPlaying, begun.length]).toEqual([false, 1]);
  source.play();
  frames(1);
  expect(begun).toHaveLength(2);
  source.play();
  frames(1);
  expect([begun.length, begun[1].isRunning, begun[2].isRunning]).toEqual([3, false, true]);
});

test.each([
  // linear fall-off ends at the range, and ignores the roll-off of the others
  [{ falloff: 'linear', referenceDistance: 2, maxDistance: 9, rolloff: 3 }, ['linear', 2, 9, 1]],
  [{ falloff: 'linear', referenceDistance: 5, maxDistance: 4, rolloff: 3 }, ['linear', 5, 5.001, 1]],
  [{ falloff: 'inverse', referenceDistance: 2, maxDistance: 9, rolloff: 3 }, ['inverse', 2, 9, 3]],
  [{ falloff: 'exponential', referenceDistance: 0.5, rolloff: 0.25 }, ['exponential', 0.5, 20, 0.25]],
] as const)('fades as its fields say: %o', async (values, expected) => {
  const source = await makeScene({ ...values, volume: 0.5, playbackRate: 2, loop: true });
  frames(1);
  await settle();
  frames(1);
  const numbers = (): unknown[] => {
    const { distanceModel, refDistance, maxDistance, rolloffFactor } = panners[0];
    return [distanceModel, refDistance, maxDistance, rolloffFactor];
  };
  expect(numbers()).toEqual(expected);
  const [, gain] = gains;
  expect([gain.gain.value, begun[0].playbackRate.value, begun[0].loop]).toEqual([0.5, 2, true]);
  // edits take effect during playback
  for (const [field, value] of Object.entries({ volume: 0.25, playbackRate: 0.5, loop: false, referenceDistance: 3 }))
    source.set(field, value);
  frames(1);
  expect([gain.gain.value, begun[0].playbackRate.value, begun[0].loop]).toEqual([0.25, 0.5, false]);
  expect(numbers()[1]).toBe(3);
});

test('stop and pause of the scene stop and pause what is heard; it goes on at the scene’s time', async () => {
  const source = await makeScene({ loop: true, positional: false, playbackRate: 2 });
  frames(1);
  await settle();
  frames(1);
  expect([begun.length, begun[0].loop, begun[0].playbackRate.value, panners.length]).toEqual([1, true, 2, 0]);
  frames(10);
  scene.pause();
  expect(begun[0].isRunning).toBe(false);
  frames(1);
  expect([begun.length, begun[1].isRunning]).toEqual([2, true]);
  // 1.3 s at twice the speed, in a loop of 2 s
  expect(source.position).toBeCloseTo(2.6, 6);
  expect(begun[1].offset).toBeCloseTo(0.6, 6);
  source.playbackRate = 1;
  expect(source.position).toBeCloseTo(2.6, 6);
  source.simulate('volume', 0.25);
  frames(1);
  expect(begun[1].playbackRate.value).toBe(1);
  expect(gains.map(({ gain }) => gain.value)).toContain(0.25);
  scene.reset();
  expect([begun[1].isRunning, source.isPlaying, source.volume]).toEqual([false, false, 1]);
  frames(1);
  expect(begun).toHaveLength(3);
  source.gameObject.active = false;
  frames(1);
  expect(begun[2].isRunning).toBe(false);
  source.gameObject.active = true;
  frames(1);
  expect(begun[3].isRunning).toBe(true);
  source.gameObject.dispose();
  frames(1);
  expect(begun[3].isRunning).toBe(false);
});

test('waits for the user’s first press, and says so; what had begun is then where it would be', async () => {
  activation.hasBeenActive = false;
  const told: boolean[] = [];
  const end = audioOutput.onChange(() => told.push(audioOutput.isWaiting));
  await makeScene({ loop: true });
  frames(4);
  expect([contexts, told]).toEqual([0, [true]]);
  activation.hasBeenActive = true;
  frames(1);
  await settle();
  frames(1);
  expect([contexts, told]).toEqual([1, [true, false]]);
  expect(begun[0].offset).toBeCloseTo(0.6, 6);
  end();
});

test('is heard from the active camera, or the listener that counts; muted it goes on in silence', async () => {
  await makeScene({ loop: true });
  const eye = new GameObject('Eye');
  eye.addComponent(Camera);
  eye.transform.position = [0, 2, 5];
  const ear = new GameObject('Ear');
  scene.add(eye).add(ear);
  frames(1);
  await settle();
  frames(1);
  const { listener } = ThreeAudioContext.getContext() as unknown as FakeContext;
  const place = (): number[] =>
    new Vector3(listener.positionX.value, listener.positionY.value, listener.positionZ.value).toArray();
  expect(place()).toEqual([0, 2, 5]);
  const own = ear.addComponent(AudioListener, { volume: 0.5 });
  ear.transform.position = [1, 0, 0];
  frames(1);
  expect([place(), gains[0].gain.value]).toEqual([[1, 0, 0], 0.5]);
  audioOutput.muted = true;
  frames(1);
  expect([gains[0].gain.value, begun.length, begun[0].isRunning]).toEqual([0, 1, true]);
  audioOutput.muted = false;
  own.enabled = false;
  frames(1);
  expect([place(), gains[0].gain.value]).toEqual([[0, 2, 5], 1]);
});

test('a sound that cannot be decoded is told once, with its name and the mend; the scene goes on', async () => {
  await makeScene();
  scene.assets.registerFile('noise.mp3', new Blob(['no sound at all']));
  await scene.assets.load('noise.mp3');
  const broken = new GameObject('Radio');
  broken.addComponent(AudioSource, { sound: 'noise.mp3' });
  scene.add(broken);
  frames(2);
  await vi.waitFor(() => expect(errors).toHaveLength(1));
  frames(5);
  await settle();
  frames(1);
  expect(errors).toEqual(["It plays 'noise.mp3', but it cannot be decoded: convert it to MP3, Ogg or WAV."]);
  expect(begun).toHaveLength(1);
});
