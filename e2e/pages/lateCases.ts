import { type FarolRenderer, type LazyPart, setShading } from '@farol/renderer';
import { setLightOptions } from '@farol/renderer/light-options';
import { LightField } from '@farol/renderer/light-field';
import * as THREE from 'three';
import { Bench } from './Bench';
import { shadowScene } from './shadowScene';
import { isSlice } from './techniquesInTurn';

const WIDTH = 64;
const HEIGHT = 48;
/** Frames in a row of one scene after which every part that it needs has been asked for: 'auto' settles after 8. */
const FRAMES = 10;

/** A scene that needs a part of the renderer's code. */
interface LateScene {
  readonly scene: THREE.Scene;
  readonly camera: THREE.Camera;
}

/** Makes a scene that needs a late part; the renderer's settings are those of a new one but for those set here. */
type MakeScene = (bench: Bench) => LateScene | Promise<LateScene>;

/** A ball over a floor, lit from one side. */
function plainScene(): LateScene & { ball: THREE.Mesh } {
  const scene = new THREE.Scene();
  const floor = new THREE.Mesh(new THREE.PlaneGeometry(8, 8), new THREE.MeshStandardMaterial({ color: 0xccbbaa }));
  floor.rotation.x = -Math.PI / 2;
  const ball = new THREE.Mesh(new THREE.SphereGeometry(1), new THREE.MeshStandardMaterial({ color: 0x4488cc }));
  ball.position.y = 1;
  const lamp = new THREE.PointLight(0xffeedd, 12, 10);
  lamp.position.set(2, 3, 2);
  scene.add(floor, ball, lamp);
  const camera = new THREE.PerspectiveCamera(50, WIDTH / HEIGHT, 0.1, 30);
  camera.position.set(0, 3, 6);
  camera.lookAt(0, 0.8, 0);
  return { scene, camera, ball };
}

const bySetting =
  (set: (farol: FarolRenderer) => void): MakeScene =>
  ({ farol }) => {
    set(farol);
    return plainScene();
  };

/** A scene for each part of the code that is fetched late. */
const cases: Readonly<Record<LazyPart, MakeScene>> = {
  shadows: ({ webgl, farol }) => {
    webgl.shadowMap.enabled = true;
    farol.technique = 'clustered-deferred';
    return shadowScene(WIDTH, HEIGHT, { caster: 'mixed', few: isSlice });
  },
  'area-lights': () => {
    const { scene, camera } = plainScene();
    const lamp = new THREE.RectAreaLight(0xffffff, 8, 2, 1);
    lamp.position.set(-2, 2.5, 2);
    lamp.lookAt(0, 0.5, 0);
    setLightOptions(lamp, { shape: 'disc' });
    scene.add(lamp);
    return { scene, camera };
  },
  views: bySetting((farol) => (farol.view = 'normal')),
  budget: bySetting((farol) => (farol.budget = { frame: 1000, min: 0.5, max: 0.5 })),
  'light-buffer': bySetting((farol) => (farol.technique = 'light-prepass')),
  multipass: bySetting((farol) => (farol.technique = 'forward')),
  'light-grid': bySetting((farol) => (farol.technique = 'clustered-forward')),
  'light-tiles': bySetting((farol) => (farol.technique = 'tiled-deferred')),
  'light-fields': () => {
    const { scene, camera } = plainScene();
    const field = new LightField(2);
    field.setPoint(0, -2, 1, 1, 5, 1, 4, 1);
    field.setPoint(1, 1, 2, 1, 5, 3, 1, 1);
    scene.add(field);
    return { scene, camera };
  },
  gouraud: () => {
    const { scene, camera, ball } = plainScene();
    setShading(ball.material as THREE.Material, 'gouraud');
    return { scene, camera };
  },
  antialiasing: ({ farol, target }) => {
    farol.technique = 'deferred';
    target.texture.type = THREE.HalfFloatType;
    target.samples = 4;
    return plainScene();
  },
  nodes: async ({ webgl }) => (await import('./nodeScene')).nodeScene(webgl, WIDTH, HEIGHT),
  timer: bySetting((farol) => (farol.timing = true)),
  'warm-up': bySetting((farol) => (farol.technique = 'auto')),
  learning: bySetting((farol) => Object.assign(farol, { technique: 'auto', learning: true })),
  'camera-arrays': () => {
    const { scene, camera } = plainScene();
    const parts = [0, WIDTH / 2].map((x) =>
      Object.assign((camera as THREE.PerspectiveCamera).clone(), {
        viewport: new THREE.Vector4(x, 0, WIDTH / 2, HEIGHT),
      }),
    );
    return { scene, camera: new THREE.ArrayCamera(parts) };
  },
  webxr: bySetting(({ webgl }) => (webgl.xr.enabled = true)),
};

/** Lights whose shadow maps the host asks for once, `by` the WebGLRenderer or by each light. */
const mapsOnce =
  (by: 'renderer' | 'lights', count: number, areaLights = 0): MakeScene =>
  ({ webgl, farol }) => {
    const { scene, camera, ball } = plainScene();
    // 'auto' would stay longer with the technique that it drew by before
    farol.technique = 'clustered-forward';
    ball.castShadow = true;
    scene.traverse((object) => (object.receiveShadow = true));
    webgl.shadowMap.enabled = true;
    const { shadowMap } = webgl;
    if (by === 'renderer') Object.assign(shadowMap, { autoUpdate: false, needsUpdate: true });
    for (let i = 0; i < count; i++) {
      const light = i % 2 === 0 ? new THREE.SpotLight(0xffffff, 40, 12, 0.7) : new THREE.PointLight(0xffffff, 12, 12);
      light.position.set(2 * Math.sin(i), 3, 2 * Math.cos(i));
      light.castShadow = true;
      light.shadow.mapSize.setScalar(64);
      if (by === 'lights') Object.assign(light.shadow, { autoUpdate: false, needsUpdate: true });
      scene.add(light);
    }
    for (let i = 0; i < areaLights; i++) {
      const light = new THREE.RectAreaLight(0xffffff, 6, 1, 1);
      light.position.set(0, 3, 3);
      light.lookAt(0, 0, 0);
      light.castShadow = true;
      scene.add(light);
    }
    return { scene, camera };
  };

/** Scenes whose shadow maps are drawn once, as by `<BakeShadows/>` of drei. */
const once = {
  'a light, asked for by it': mapsOnce('lights', 1),
  'four lights, asked for by the renderer': mapsOnce('renderer', 4),
  'twelve lights, which three has no textures for': mapsOnce('renderer', 12),
  'a light and an area light': mapsOnce('renderer', 1, 1),
};

const scenes: Readonly<Record<string, MakeScene>> = { ...cases, ...once };

/** A renderer that draws a scene, again whenever it asks for that. */
export class LateCase {
  /** Whether the picture is as it stays, by `FarolRenderer.ready`. */
  isReady = false;
  private readonly bench = new Bench(WIDTH, HEIGHT);
  private made!: LateScene;
  private picture: Float32Array = new Float32Array();

  private constructor(readonly name: string) {
    this.bench.farol.addEventListener('redraw', () => this.draw());
  }

  /** Names of the scenes whose shadow maps are drawn once. */
  static readonly once: readonly string[] = Object.keys(once);

  /** @param name - of a part, or of `once` */
  static async of(name: string): Promise<LateCase> {
    const late = new LateCase(name);
    late.made = await scenes[name](late.bench);
    return late;
  }

  /** Draws as many frames as it takes to ask for any part. @returns names of the parts that are pending then */
  drawFrames(): readonly string[] {
    for (let frame = 0; frame < FRAMES; frame++) this.draw();
    return this.bench.farol.info.pending;
  }

  /** Draws a frame to the canvas after `compileAsync`. @returns what is pending then, and how many programs it compiled */
  async drawCompiled(): Promise<{ pending: readonly string[]; programs: number }> {
    const { farol, webgl } = this.bench;
    const { scene, camera } = this.made;
    await farol.compileAsync(scene, camera);
    const before = new Set(webgl.info.programs);
    farol.render(scene, camera);
    const { pending } = farol.info;
    const programs = webgl.info.programs!.filter((program) => !before.has(program)).length;
    this.dispose();
    return { pending, programs };
  }

  /** Draws no frame but those that the renderer asks for. @returns fulfilled when the picture is as it stays */
  async wait(): Promise<void> {
    await this.bench.farol.ready;
    this.isReady = true;
  }

  /** Draws two frames after `wait`. @returns largest difference of each from what another renderer draws, now that all code is there */
  async differences(): Promise<number[]> {
    const pictures = [this.picture, this.draw(), this.draw()];
    // in the same context, where the shaders are compiled
    this.dispose();
    const there = await LateCase.of(this.name);
    const pending = there.drawFrames();
    if (pending.length > 0) throw new Error(`${pending.join(', ')} came no sooner for the picture to compare with`);
    const wanted = there.draw();
    there.dispose();
    return pictures.map((picture) => largest(picture, wanted));
  }

  /** Shadow maps that light the picture. */
  get maps(): number {
    const { drawn, kept } = this.bench.farol.info.shadows;
    return drawn + kept;
  }

  private dispose(): void {
    this.bench.free();
  }

  private draw(): Float32Array {
    const { bench, made } = this;
    this.picture = bench.draw(() => bench.farol.render(made.scene, made.camera)).data;
    return this.picture;
  }
}

const largest = (a: Float32Array, b: Float32Array): number =>
  a.reduce((most, value, i) => Math.max(most, Math.abs(value - b[i])), 0);
