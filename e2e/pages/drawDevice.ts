import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import { type EffectName, loadEffects } from '@farol/renderer/effects';
import * as THREE from 'three';
import { compareImages, type Difference } from '../support/images';
import { devices, type DeviceName, subtract, type Subtraction } from './devices';
import type { PageImage } from './Bench';
import { shadowScene } from './shadowScene';
import type { TestScene } from './materialScene';

const WIDTH = 160;
const HEIGHT = 90;

const effectClasses = await loadEffects();

/** Result of a technique, with or without an effect, on a device. */
export interface DeviceResult extends Partial<Difference> {
  readonly technique: string;
  readonly effect: string;
  /** Message that was thrown when the technique was set, or empty. */
  readonly refused: string;
  /** GL errors in its frames. */
  readonly errors: number;
  /** PSNR (dB) against stock three on this machine's device with nothing taken away. */
  readonly wholePSNR?: number;
}

export interface DeviceResults {
  readonly results: DeviceResult[];
  /** Calls beyond the device's limits. */
  readonly beyond: string[];
  /** PSNR (dB) of stock three on the device against stock three on the whole one; infinite where that is not asked for. */
  readonly stockPSNR: number;
}

export interface DeviceRun {
  readonly names: readonly TechniqueName[];
  readonly effectNames: readonly EffectName[];
  /** Draws `shadowScene` in place of a scene of few programs. */
  readonly whole: boolean;
  /** Also compares with the device before the subtraction: for precision, which a driver may not lower. */
  readonly rounds: boolean;
}

/** A lit floor with a shadow, a box with its edges, glass: few programs. */
function deviceScene(): TestScene {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x101418);
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(14, 14), new THREE.MeshStandardMaterial({ roughness: 0.7 }));
  floor.rotation.x = -Math.PI / 2;
  floor.receiveShadow = true;
  const box = new THREE.Mesh(new THREE.BoxGeometry(2, 2, 2), new THREE.MeshPhongMaterial({ color: 0xee9966 }));
  box.position.set(-1.2, 1, 0);
  box.castShadow = true;
  const glass = new THREE.Mesh(
    new THREE.PlaneGeometry(2, 2),
    new THREE.MeshStandardMaterial({ color: 0xffaa66, transparent: true, opacity: 0.5 }),
  );
  glass.position.set(1, 1.2, 1.8);
  const edges = new THREE.LineSegments(new THREE.EdgesGeometry(box.geometry), new THREE.LineBasicMaterial());
  edges.scale.setScalar(1.02);
  box.add(edges);
  scene.add(floor, box, glass, new THREE.HemisphereLight(0x8899aa, 0x332211, 0.4));
  const sun = new THREE.DirectionalLight(0xffeecc, 0.6);
  sun.position.set(-2, 4, 3);
  const spot = new THREE.SpotLight(0xddeeff, 150, 20, 0.6, 0.4, 2);
  spot.position.set(3, 6, 3);
  spot.castShadow = true;
  spot.shadow.mapSize.set(256, 256);
  spot.shadow.bias = -0.004;
  spot.map = new THREE.DataTexture(new Uint8Array([255, 200, 90, 255, 90, 160, 255, 255]), 2, 1);
  spot.map.magFilter = THREE.LinearFilter;
  spot.map.needsUpdate = true;
  const lights: THREE.Light[] = [sun, spot];
  for (let i = 0; i < 6; i++) {
    const point = new THREE.PointLight(new THREE.Color().setHSL(i / 6, 0.8, 0.6), 8, 5);
    point.position.set(3 * Math.cos(i), 1 + (i % 3) / 2, 3 * Math.sin(i));
    lights.push(point);
  }
  scene.add(...lights);
  const camera = new THREE.PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 60);
  camera.position.set(0, 3.4, 7);
  camera.lookAt(0, 1, 0);
  return { scene, camera, lights };
}

/**
 * Draws a scene of lights, shadows, lines and glass on a device that lacks something, by techniques and by stock three,
 * into a target of the finest colour that the device draws to. Each effect is drawn by `deferred` and by
 * `forward-plus`; if `names` has a single technique and `whole` is false, by that alone.
 */
export function drawDevice(device: DeviceName, { names, effectNames, whole, rounds }: DeviceRun): DeviceResults {
  const reference = rounds ? wholeStock(whole, devices[device]) : null;
  const beyond = subtract(devices[device]);
  const webgl = new THREE.WebGLRenderer({ antialias: false });
  webgl.setSize(WIDTH, HEIGHT, false);
  webgl.shadowMap.enabled = true;
  const gl = webgl.getContext() as WebGL2RenderingContext;
  const target = makeTarget(webgl);
  const { scene, camera } = makeScene(whole);
  let errors = 0;
  const draw = (render: () => void): PageImage => {
    webgl.setRenderTarget(target);
    render();
    errors = 0;
    while (gl.getError() !== 0) errors++;
    const image = read(webgl, target);
    webgl.setRenderTarget(null);
    return image;
  };
  const farol = new FarolRenderer(webgl, { quality: 'full' });
  const stock = draw(() => webgl.render(scene, camera));
  const results: DeviceResult[] = [];
  const run = (technique: TechniqueName, effect: EffectName | null): void => {
    const told = { technique, effect: effect ?? 'none' };
    try {
      farol.technique = technique;
      farol.effects = effect === null ? [] : [new effectClasses[effect]()];
      let image!: PageImage;
      // the second frame has all code and programs
      let all = 0;
      for (let i = 0; i < (effect === null ? 1 : 2); i++) {
        image = draw(() => farol.render(scene, camera));
        all += errors;
      }
      const wholePSNR = reference ? compareImages(reference, image).psnr : undefined;
      results.push({ ...told, refused: '', errors: all, wholePSNR, ...compareImages(stock, image) });
    } catch (error) {
      while (gl.getError() !== 0);
      webgl.setRenderTarget(null);
      results.push({ ...told, refused: (error as Error).message, errors: 0 });
    }
    for (const one of farol.effects) one.dispose();
    farol.effects = [];
  };
  for (const name of names) run(name, null);
  const byEffect: readonly TechniqueName[] = whole || names.length > 1 ? ['deferred', 'forward-plus'] : names;
  for (const name of effectNames) for (const technique of byEffect) run(technique, name);
  return { results, beyond: [...beyond], stockPSNR: reference ? compareImages(reference, stock).psnr : Infinity };
}

/** Picture of a device by the quality that 'auto' is there, against 'full'. */
export interface DeviceQuality extends Difference {
  readonly quality: string;
  readonly gbufferPixel: number;
  /** GL errors. */
  readonly errors: number;
  /** Calls beyond the device's limits. */
  readonly beyond: string[];
}

/**
 * Draws a scene of lights and shadows by a technique and the quality 'auto' on a device that lacks something.
 *
 * @param whole - draws `shadowScene` in place of a scene of few programs
 */
export function drawQuality(device: DeviceName, technique: TechniqueName, whole: boolean): DeviceQuality {
  const beyond = subtract(devices[device]);
  const webgl = new THREE.WebGLRenderer({ antialias: false });
  webgl.setSize(WIDTH, HEIGHT, false);
  webgl.shadowMap.enabled = true;
  const target = makeTarget(webgl);
  const { scene, camera } = makeScene(whole);
  const farol = new FarolRenderer(webgl, { technique });
  const draw = (): PageImage => {
    webgl.setRenderTarget(target);
    farol.render(scene, camera);
    return read(webgl, target);
  };
  const own = draw();
  const { quality, memory } = farol.info;
  const { gbufferPixel } = memory;
  farol.quality = 'full';
  const full = draw();
  let errors = 0;
  while (webgl.getContext().getError() !== 0) errors++;
  return { ...compareImages(full, own), quality, gbufferPixel, errors, beyond: [...beyond] };
}

function makeScene(whole: boolean): TestScene {
  const made = whole ? shadowScene(WIDTH, HEIGHT, { caster: 'mixed' }) : deviceScene();
  const edges = new THREE.LineSegments(
    new THREE.EdgesGeometry(new THREE.BoxGeometry(1.1, 1.7, 1.1)),
    new THREE.LineBasicMaterial({ color: 0x00ffaa }),
  );
  edges.position.set(-1.6, 0.8, 0);
  made.scene.add(edges);
  return made;
}

/** A target of the finest colour that a device draws to. @param hidden - extensions that it is to lack besides */
function makeTarget({ extensions }: THREE.WebGLRenderer, hidden: readonly string[] = []): THREE.WebGLRenderTarget {
  const has = (name: string): boolean => extensions.has(name) && !hidden.includes(name);
  const floats = has('EXT_color_buffer_float');
  const halves = floats || has('EXT_color_buffer_half_float');
  const blended = floats && has('EXT_float_blend') ? THREE.FloatType : THREE.HalfFloatType;
  return new THREE.WebGLRenderTarget(WIDTH, HEIGHT, { type: halves ? blended : THREE.UnsignedByteType });
}

/** The scene by stock three, before anything is taken from the device, in a target as the device has. */
function wholeStock(whole: boolean, { extensions = [] }: Subtraction): PageImage {
  const webgl = new THREE.WebGLRenderer({ antialias: false });
  webgl.setSize(WIDTH, HEIGHT, false);
  webgl.shadowMap.enabled = true;
  const target = makeTarget(webgl, extensions);
  const { scene, camera } = makeScene(whole);
  webgl.setRenderTarget(target);
  webgl.render(scene, camera);
  const image = read(webgl, target);
  target.dispose();
  webgl.dispose();
  return image;
}

function read(webgl: THREE.WebGLRenderer, target: THREE.WebGLRenderTarget): PageImage {
  const { width, height } = target;
  const count = width * height * 4;
  const take = <T extends Float32Array | Uint16Array | Uint8Array>(values: T): T => {
    webgl.readRenderTargetPixels(target, 0, 0, width, height, values);
    return values;
  };
  const { type } = target.texture;
  const data =
    type === THREE.FloatType
      ? take(new Float32Array(count))
      : type === THREE.HalfFloatType
        ? Float32Array.from(take(new Uint16Array(count)), (half) => THREE.DataUtils.fromHalfFloat(half))
        : Float32Array.from(take(new Uint8Array(count)), (byte) => byte / 255);
  return { width, height, data };
}
