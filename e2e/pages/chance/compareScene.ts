import type { TechniqueName } from '@farol/renderer';
import * as THREE from 'three';
import { compareImages, type Difference, figuresOf, isFlat } from '../../support/images';
import { Bench, type PageImage } from '../Bench';
import { drawn } from '../techniquesInTurn';
import { type BuiltScene, buildScene, Materials } from './buildScene';
import { ownOf } from './leftOut';
import type { SceneFacts, ViewFacts } from './SceneFacts';

export const WIDTH = 192;
export const HEIGHT = 144;
/** Signal to noise, at least (dB), share of pixels off by more than 2/255, at most, and difference of alpha, at most. */
const PSNR = 50;
const SHARE = 0.001;
const ALPHA = 1e-4;
/** A step of 8 bits. */
const STEP = 1.01 / 255;

/** Techniques whose pictures are to be stock three's: `inferred` lights transparent layers at some of their pixels. */
export const compared: readonly TechniqueName[] = drawn.filter((name) => name !== 'inferred');

/** How a technique drew a scene. */
export interface SceneResult {
  readonly technique: TechniqueName;
  readonly difference: Difference;
  /** Why it is off, in words; null when it is not. */
  readonly fault: string | null;
  /** Whether the fault is what was thrown, or said to the console. */
  readonly isSaid: boolean;
}

const benches = new Map<string, Bench>();
const materials = new Materials();

function benchOf({ depth }: ViewFacts): Bench {
  const key = depth ?? '';
  let bench = benches.get(key);
  if (bench === undefined) {
    const parameters = depth && { [`${depth}DepthBuffer`]: true };
    bench = new Bench(WIDTH, HEIGHT, { renderer: parameters ?? {}, target: { stencilBuffer: true } });
    bench.webgl.localClippingEnabled = true;
    bench.webgl.shadowMap.enabled = true;
    bench.farol.inferredScale = 1;
    benches.set(key, bench);
  }
  return bench;
}

/** Forgets what scenes share: to be called when a deck has ended, before the test has its benches released. */
export function forgetScenes(): void {
  materials.dispose();
  benches.clear();
}

function readTarget(webgl: THREE.WebGLRenderer, target: THREE.WebGLRenderTarget): PageImage {
  const { width, height } = target;
  const count = width * height * 4;
  const { type } = target.texture;
  if (type === THREE.FloatType) {
    const data = new Float32Array(count);
    webgl.readRenderTargetPixels(target, 0, 0, width, height, data);
    return { width, height, data };
  }
  const raw = type === THREE.HalfFloatType ? new Uint16Array(count) : new Uint8Array(count);
  webgl.readRenderTargetPixels(target, 0, 0, width, height, raw);
  if (raw instanceof Uint8Array) return imageOf(raw, width, height);
  return { width, height, data: Float32Array.from(raw, THREE.DataUtils.fromHalfFloat) };
}

/** Treats bytes of any encoding as sRGB, so that a step of a byte is a step of 1/255 to `compareImages`. */
function imageOf(bytes: Uint8Array, width: number, height: number): PageImage {
  const linear = (value: number) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
  const data = Float32Array.from(bytes, (byte, i) => (i % 4 === 3 ? byte / 255 : linear(byte / 255)));
  return { width, height, data };
}

export function readCanvas(webgl: THREE.WebGLRenderer): PageImage {
  const gl = webgl.getContext();
  const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
  const bytes = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return imageOf(bytes, width, height);
}

/** Target of a drawing: that of a bench, one of another type, or the canvas. */
class Output {
  readonly target: THREE.WebGLRenderTarget | null;

  constructor(
    private readonly bench: Bench,
    { target }: ViewFacts,
  ) {
    const type = target === 'half' ? THREE.HalfFloatType : THREE.UnsignedByteType;
    if (target === 'canvas') this.target = null;
    else if (target === undefined) this.target = bench.target;
    else this.target = new THREE.WebGLRenderTarget(WIDTH, HEIGHT, { type, stencilBuffer: true });
  }

  /** @param technique - null: stock three */
  draw(scene: BuiltScene, technique: TechniqueName | null): PageImage {
    const { webgl, farol } = this.bench;
    const { target } = this;
    if (technique !== null) farol.technique = technique;
    webgl.setRenderTarget(target);
    try {
      scene.draw(webgl, technique === null ? null : farol);
    } finally {
      target?.viewport.set(0, 0, WIDTH, HEIGHT);
      if (target) target.scissorTest = false;
      webgl.setRenderTarget(target);
    }
    const image = target === null ? readCanvas(webgl) : readTarget(webgl, target);
    webgl.setRenderTarget(null);
    const error = webgl.getContext().getError();
    if (error !== 0) throw new Error(`WebGL error ${error}`);
    return image;
  }

  dispose(): void {
    if (this.target !== this.bench.target) this.target?.dispose();
  }
}

/** Runs something, and keeps from the console what it says there. */
export function listen<T>(run: () => T): { result: T | null; said: string[] } {
  const said: string[] = [];
  const { warn, error } = console;
  console.warn = console.error = (...words: unknown[]) => void said.push(words.map(String).join(' ').slice(0, 300));
  try {
    return { result: run(), said };
  } catch (thrown) {
    said.push(`thrown: ${thrown instanceof Error ? thrown.message : String(thrown)}`);
    return { result: null, said };
  } finally {
    console.warn = warn;
    console.error = error;
  }
}

function faultOf(difference: Difference, { target }: ViewFacts): string | null {
  const { psnr, share, alpha } = difference;
  const most = target === undefined ? ALPHA : target === 'half' ? 1e-3 : STEP;
  return psnr >= PSNR && share <= SHARE && alpha <= most ? null : figuresOf(difference);
}

/** Pictures that say nothing: stock three shows one colour, or values that are not finite, or cannot draw them. */
export interface Unseen {
  readonly unseen: string;
}

/**
 * Draws a scene by stock three and by techniques. What stock three has not is compared with one of them: see `ownOf`.
 */
export function compareScene(facts: SceneFacts, techniques = compared): SceneResult[] | Unseen {
  const { view = {} } = facts;
  const bench = benchOf(view);
  const { reference, able } = ownOf(facts);
  const scene = buildScene(facts, bench, materials);
  const output = new Output(bench, view);
  try {
    // the first picture is left out: see `leftOut`
    if (view.camera === 'array') listen(() => output.draw(scene, reference));
    const stock = listen(() => output.draw(scene, reference));
    if (stock.result === null) return { unseen: stock.said.at(-1) ?? '' };
    if (isFlat(stock.result)) return { unseen: 'one colour' };
    const image = stock.result;
    return techniques.filter(able).map((technique) => {
      const { result, said } = listen(() => output.draw(scene, technique));
      const words = said.filter((text) => !stock.said.includes(text));
      const difference = result
        ? compareImages(image, result)
        : { largest: Infinity, psnr: 0, share: 1, alpha: Infinity };
      const isSaid = words.length > 0;
      return { technique, difference, isSaid, fault: isSaid ? words.join('; ') : faultOf(difference, view) };
    });
  } finally {
    output.dispose();
    scene.dispose();
  }
}
