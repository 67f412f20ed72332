import type { FarolEffect, TechniqueName } from '@farol/renderer';
import { WeightedBlendedOIT } from '@farol/renderer/transparency';
import { VolumetricFog } from '@farol/renderer/volumetric-fog';
import { Particles } from '@farol/renderer/particles';
import { FarolPostPass } from '@farol/renderer/postprocessing';
import { FarolPass } from '@farol/renderer/three-pass';
import * as pmndrs from 'postprocessing';
import * as THREE from 'three';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { compareImages, type Difference } from '../support/images';
import { Bench, type BenchOptions, type PageImage } from './Bench';
import { oneParticle } from './oneParticle';

const WIDTH = 48;
const HEIGHT = 32;
/** Distance along the view of what is held before the camera (m). */
const DEPTH = 4;

const streets: Street[] = [];

/** A lamp over a floor in fog, without jitter, so that a frame is as the next. */
class Street {
  readonly scene = new THREE.Scene();
  readonly camera = new THREE.PerspectiveCamera(60, WIDTH / HEIGHT, 0.1, 50);
  readonly fog = new VolumetricFog();
  readonly bench: Bench;

  constructor(options?: BenchOptions) {
    const { scene, camera, fog } = this;
    this.bench = new Bench(WIDTH, HEIGHT, options);
    camera.position.set(0, 1, 4);
    camera.lookAt(0.2, 0.8, 0);
    scene.background = new THREE.Color(0.1, 0.15, 0.3);
    const floor = new THREE.Mesh(new THREE.PlaneGeometry(12, 12), new THREE.MeshLambertMaterial());
    floor.rotation.x = -Math.PI / 2;
    const lamp = new THREE.PointLight(0xffaa66, 12, 8);
    lamp.position.set(0.8, 1.4, -1);
    const box = new THREE.Mesh(new THREE.BoxGeometry(0.8, 1.6, 0.8), floor.material);
    box.position.set(-1.2, 0.8, -0.6);
    scene.add(floor, box, lamp, new THREE.AmbientLight(0x8090a0, 0.5), camera);
    Object.assign(fog, { density: 0.12, anisotropy: 0.4, distance: 14, time: 0, frames: 1, froxels: [24, 16, 32] });
    this.bench.farol.effects = [fog];
    streets.push(this);
  }

  read(target: THREE.WebGLRenderTarget): PageImage {
    const data = new Float32Array(WIDTH * HEIGHT * 4);
    this.bench.webgl.readRenderTargetPixels(target, 0, 0, WIDTH, HEIGHT, data);
    return { width: WIDTH, height: HEIGHT, data };
  }

  draw(technique: TechniqueName, camera: THREE.Camera = this.camera): PageImage {
    this.fog.reset();
    return this.bench.byTechnique(technique, this.scene, camera);
  }
}

function partOf({ width, data }: PageImage, x: number, y: number, w: number, h: number): PageImage {
  const part = new Float32Array(w * h * 4);
  for (let row = 0; row < h; row++)
    part.set(data.subarray(((y + row) * width + x) * 4).subarray(0, w * 4), row * w * 4);
  return { width: w, height: h, data: part };
}

type Host = (technique: TechniqueName) => Difference;

const hosts = {
  'a viewport and scissor of a larger target': (technique) => {
    const street = new Street();
    const { bench, scene, camera } = street;
    const alone = street.draw(technique);
    bench.setSize(WIDTH * 2, HEIGHT * 2);
    const { target } = bench;
    target.viewport.set(WIDTH - 7, 13, WIDTH, HEIGHT);
    target.scissor.copy(target.viewport);
    target.scissorTest = true;
    const image = bench.byTechnique(technique, scene, camera);
    return compareImages(alone, partOf(image, WIDTH - 7, 13, WIDTH, HEIGHT));
  },
  'an array of cameras': (technique) => {
    const street = new Street();
    const eyes = [0, 1].map((i) => {
      const eye = street.camera.clone() as THREE.PerspectiveCamera & { viewport: THREE.Vector4 };
      eye.position.x += i * 0.6;
      eye.viewport = new THREE.Vector4((i * WIDTH) / 2, 0, WIDTH / 2, HEIGHT);
      eye.aspect /= 2;
      eye.updateProjectionMatrix();
      eye.updateMatrixWorld();
      return eye;
    });
    const array = new THREE.ArrayCamera(eyes);
    array.copy(street.camera, false);
    array.cameras = eyes;
    const both = street.draw(technique, array);
    const { bench } = street;
    bench.setSize(WIDTH / 2, HEIGHT);
    const apart = eyes.map((eye, i) =>
      compareImages(street.draw(technique, eye), partOf(both, (i * WIDTH) / 2, 0, WIDTH / 2, HEIGHT)),
    );
    return apart[0].psnr < apart[1].psnr ? apart[0] : apart[1];
  },
  'a cube camera': (technique) => {
    const street = new Street();
    const { bench, scene, fog } = street;
    const target = new THREE.WebGLCubeRenderTarget(32, { type: THREE.FloatType });
    const cube = new THREE.CubeCamera(0.1, 50, target);
    cube.position.set(0, 1, 1);
    bench.farol.technique = technique;
    fog.froxels = [32, 32, 32];
    const { webgl } = bench;
    cube.updateMatrixWorld();
    cube.coordinateSystem = webgl.coordinateSystem;
    cube.updateCoordinateSystem();
    let worst!: Difference;
    bench.setSize(32, 32);
    (cube.children as THREE.PerspectiveCamera[]).forEach((face, i) => {
      face.updateMatrixWorld();
      webgl.setRenderTarget(target, i);
      bench.farol.render(scene, face);
      webgl.setRenderTarget(null); // three's read-back rebinds the current target, and fails for a cube
      const data = new Float32Array(32 * 32 * 4);
      webgl.readRenderTargetPixels(target, 0, 0, 32, 32, data, i);
      const alone = bench.byTechnique(technique, scene, face);
      const difference = compareImages(alone, { width: 32, height: 32, data });
      if (i === 0 || difference.psnr < worst.psnr) worst = difference;
    });
    target.dispose();
    return worst;
  },
  'a multisampled target': (technique) => {
    const street = new Street();
    const alone = street.draw(technique);
    const other = new Street({ samples: 4 });
    const image = other.draw(technique);
    // edges, smooth in the multisampled picture alone, are left out of the comparison
    let edges = 0;
    for (let i = 0; i < image.data.length; i += 4) {
      if (Math.abs(image.data[i] - alone.data[i]) < 0.01) continue;
      image.data.set(alone.data.subarray(i, i + 4), i);
      edges++;
    }
    if (edges > 0.1 * WIDTH * HEIGHT) throw new Error(`${edges} pixels differ`);
    return compareImages(alone, image);
  },
  'another size, and froxels of another number': (technique) => {
    const street = new Street();
    const { bench, fog, camera } = street;
    const first = street.draw(technique);
    bench.setSize(80, 20);
    Object.assign(camera, { aspect: 4 }).updateProjectionMatrix();
    fog.froxels = [40, 10, 16];
    street.draw(technique);
    bench.setSize(WIDTH, HEIGHT);
    Object.assign(camera, { aspect: WIDTH / HEIGHT }).updateProjectionMatrix();
    fog.froxels = [24, 16, 32];
    return compareImages(first, street.draw(technique));
  },
  'logarithmic depth': (technique) =>
    compareImages(
      new Street().draw(technique),
      new Street({ renderer: { logarithmicDepthBuffer: true } }).draw(technique),
    ),
  'reversed depth': (technique) =>
    compareImages(
      new Street().draw(technique),
      new Street({ renderer: { reversedDepthBuffer: true } }).draw(technique),
    ),
  'three’s composer': (technique) => {
    const street = new Street();
    const { bench, scene, camera } = street;
    const alone = street.draw(technique);
    const composer = new EffectComposer(
      bench.webgl,
      new THREE.WebGLRenderTarget(WIDTH, HEIGHT, { type: THREE.FloatType }),
    );
    composer.renderToScreen = false;
    composer.addPass(new FarolPass(bench.farol, scene, camera));
    composer.render(0);
    const image = street.read(composer.readBuffer);
    composer.dispose();
    return compareImages(alone, image);
  },
  'pmndrs’ composer': (technique) => {
    const street = new Street();
    const { bench, scene, camera } = street;
    const alone = street.draw(technique);
    const composer = new pmndrs.EffectComposer(bench.webgl, { frameBufferType: THREE.FloatType });
    composer.autoRenderToScreen = false;
    composer.addPass(new FarolPostPass(bench.farol, scene, camera));
    composer.render(0);
    const image = street.read(composer.inputBuffer);
    composer.dispose();
    bench.webgl.autoClear = true;
    return compareImages(alone, image);
  },
  'the tiles of a larger picture': (technique) => {
    const street = new Street();
    const { camera, bench, fog } = street;
    fog.froxels = [48, 32, 32];
    const whole = street.draw(technique);
    fog.froxels = [24, 16, 32];
    bench.setSize(WIDTH / 2, HEIGHT / 2);
    const image: PageImage = { width: WIDTH, height: HEIGHT, data: new Float32Array(whole.data.length) };
    for (const x of [0, WIDTH / 2])
      for (const y of [0, HEIGHT / 2]) {
        camera.setViewOffset(WIDTH, HEIGHT, x, HEIGHT / 2 - y, WIDTH / 2, HEIGHT / 2);
        const tile = street.draw(technique);
        for (let row = 0; row < HEIGHT / 2; row++) {
          const line = tile.data.subarray((row * WIDTH * 4) / 2, ((row + 1) * WIDTH * 4) / 2);
          image.data.set(line, ((y + row) * WIDTH + x) * 4);
        }
      }
    return compareImages(whole, image);
  },
} satisfies Record<string, Host>;

export type FogHostName = keyof typeof hosts;

/** The picture of a street in fog as a host has it drawn, against that of the bench's own target. */
export function fogInHost(name: FogHostName, technique: TechniqueName): Difference {
  const difference = hosts[name](technique);
  for (const { bench } of streets.splice(0)) bench.free();
  return difference;
}

interface Veil {
  /** Before the camera, DEPTH away. */
  readonly object: THREE.Object3D;
  /**
   * A pixel's channel that it covers.
   * @param behind - of what is behind, in fog
   * @param fog - of the fog before it
   * @param passes - transmittance of that fog
   * @param share - how much of it there is in the pixel, by the picture without fog
   */
  expected(behind: number, fog: number, passes: number, share: number): number;
  /** Whether it adds light and hides none. */
  readonly isAdded?: boolean;
  readonly effects?: readonly FarolEffect[];
}

const VALUE = 0.6;
const plane = new THREE.PlaneGeometry(2, 2);
const held = (material: THREE.Material): THREE.Object3D => new THREE.Mesh(plane, material);
const particle = (settings: Parameters<typeof oneParticle>[0]): THREE.Object3D => {
  const emitter = oneParticle({ ...settings, size: [2, 2] });
  emitter.step(0.03);
  return emitter;
};
const grey = new THREE.Color(VALUE, VALUE, VALUE);
const expected: Veil['expected'] = (behind, fog, passes, share) =>
  behind * (1 - share) + share * (VALUE * passes + fog);
const added: Pick<Veil, 'expected' | 'isAdded'> = {
  expected: (behind, _, passes, share) => behind + share * VALUE * passes,
  isAdded: true,
};

const veils: Record<string, () => Veil> = {
  'a blended pane': () => ({
    object: held(new THREE.MeshBasicMaterial({ color: grey, transparent: true, opacity: 0.4 })),
    expected,
  }),
  'a lit pane': () => ({
    object: held(new THREE.MeshLambertMaterial({ color: 0, emissive: grey, transparent: true, opacity: 0.4 })),
    expected,
  }),
  'a pane by WeightedBlendedOIT': () => ({
    object: held(new THREE.MeshBasicMaterial({ color: grey, transparent: true, opacity: 0.4 })),
    expected,
    effects: [new WeightedBlendedOIT()],
  }),
  'premultiplied colours': () => ({
    object: held(
      new THREE.MeshBasicMaterial({ color: grey, transparent: true, opacity: 0.4, premultipliedAlpha: true }),
    ),
    expected,
  }),
  'added light': () => ({
    object: held(
      new THREE.MeshBasicMaterial({ color: grey, transparent: true, opacity: 0.5, blending: THREE.AdditiveBlending }),
    ),
    ...added,
  }),
  'what a test of alpha leaves': () => ({
    object: held(new THREE.MeshBasicMaterial({ color: grey, alphaTest: 0.5 })),
    expected,
  }),
  'a sprite': () => {
    const object = new THREE.Sprite(new THREE.SpriteMaterial({ color: grey, opacity: 0.4 }));
    object.scale.setScalar(2);
    return { object, expected };
  },
  points: () => {
    const geometry = new THREE.BufferGeometry().setFromPoints([new THREE.Vector3()]);
    const material = new THREE.PointsMaterial({ color: grey, size: 15, sizeAttenuation: false, transparent: true });
    material.opacity = 0.4;
    return { object: new THREE.Points(geometry, material), expected };
  },
  'a shader of the host': () => ({
    object: held(
      new THREE.ShaderMaterial({
        transparent: true,
        fragmentShader: `void main() { gl_FragColor = vec4(vec3(${VALUE}), 0.4); }`,
      }),
    ),
    expected,
  }),
  particles: () => ({
    object: particle({ colorOverLife: [[0, [VALUE, VALUE, VALUE], 0.4]] }),
    expected,
    effects: [new Particles()],
  }),
  'added particles': () => ({
    object: particle({ colorOverLife: [[0, [VALUE, VALUE, VALUE], 0.5]], blending: 'additive' }),
    ...added,
    effects: [new Particles()],
  }),
  'clear glass': () => ({
    object: held(new THREE.MeshPhysicalMaterial({ transmission: 1, ior: 1, roughness: 0, specularIntensity: 0 })),
    expected: (behind) => behind,
  }),
  'tinted glass': () => ({
    object: held(
      new THREE.MeshPhysicalMaterial({ color: grey, transmission: 1, ior: 1, roughness: 0, specularIntensity: 0 }),
    ),
    expected: (behind, fog) => (behind - fog) * VALUE + fog,
  }),
};

export const veilNames = Object.keys(veils);

/**
 * Compares a transparent thing in fog with what its blending gives for the fog before it; that fog is measured on a
 * black and a white sheet at the same distance. `covered` counts the pixels that the thing covers.
 */
export function fogBefore(name: string, technique: TechniqueName): Difference & { covered: number } {
  const { object, expected: wantedOf, isAdded = false, effects = [] } = veils[name]();
  const street = new Street();
  const { bench, camera, fog, scene } = street;
  // nothing but the background lies behind, since glass would blur anything else
  for (const mesh of scene.children) if (mesh instanceof THREE.Mesh) mesh.visible = false;
  const all = [...(effects ?? [])];
  bench.farol.effects = [fog, ...all];
  const behind = street.draw(technique);
  const sheets = [0, 0xffffff].map((color) => {
    const sheet = new THREE.Mesh(new THREE.PlaneGeometry(20, 20), new THREE.MeshBasicMaterial({ color }));
    sheet.position.z = -DEPTH;
    camera.add(sheet);
    const image = street.draw(technique);
    camera.remove(sheet);
    return image;
  });
  object.position.z = -DEPTH;
  camera.add(object);
  bench.farol.effects = all;
  bench.byTechnique(technique, scene, camera);
  const bare = bench.byTechnique(technique, scene, camera);
  bench.farol.effects = [fog, ...all];
  const image = street.draw(technique);
  camera.remove(object);
  bench.farol.effects = all;
  const none = bench.byTechnique(technique, scene, camera);
  const wanted = behind.data.slice();
  let covered = 0;
  // clear glass changes no pixel without fog, so all count; other things cover the pixels that they change
  const isClear = name === 'clear glass';
  for (let i = 0; i < wanted.length; i += 4) {
    if (!isClear && Math.abs(bare.data[i] - none.data[i]) < 1e-3) continue;
    covered++;
    for (let k = i; k < i + 3; k++) {
      const fogged = sheets[0].data[k];
      const share = (bare.data[k] - none.data[k]) / (isAdded ? VALUE : VALUE - none.data[k]);
      wanted[k] = wantedOf(behind.data[k], fogged, sheets[1].data[k] - fogged, share);
    }
  }
  for (const effect of all) effect.dispose();
  streets.splice(0);
  bench.free();
  return { ...compareImages({ ...behind, data: wanted }, image), covered };
}

/** Largest difference that fog makes to the picture of an orthographic camera, of which a warning is told once. */
export function fogOrthographic(technique: TechniqueName): number {
  const { bench, fog, scene } = new Street();
  const camera = new THREE.OrthographicCamera(-3, 3, 2, -2, 0.1, 50);
  camera.position.set(0, 1, 4);
  bench.farol.effects = [];
  const without = bench.byTechnique(technique, scene, camera);
  bench.farol.effects = [fog];
  bench.byTechnique(technique, scene, camera);
  return compareImages(without, bench.byTechnique(technique, scene, camera)).largest;
}
