import { CommandStack, type FieldTarget } from '@farol/editing';
import { App, GameObject } from '@farol/engine';
import { FarolRenderer } from '@farol/renderer';
import type { LightField } from '@farol/renderer/light-field';
import {
  type Camera,
  type InstancedMesh,
  type Material,
  Mesh,
  MeshLambertMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  type SpotLight,
  WebGLRenderer,
  type WebGLRenderTarget,
} from 'three';
import { litScene } from './host/litScene';

/** Resolves when a FarolRenderer of the page has drawn a frame. */
const firstFrame = new Promise<void>((resolve) => {
  const { render } = FarolRenderer.prototype;
  FarolRenderer.prototype.render = function (this: FarolRenderer, scene, camera) {
    render.call(this, scene, camera);
    if (this.info.drawCalls > 0 || scene.children.length === 0) resolve();
  };
});

/** @throws Error with the message unless it is true */
function check(isTrue: boolean, message: string): void {
  if (!isTrue) throw new Error(message);
}

function host() {
  const webgl = new WebGLRenderer();
  webgl.setSize(160, 120);
  const camera = new PerspectiveCamera(50, 4 / 3, 0.1, 200);
  camera.position.set(0, 4, 7);
  camera.lookAt(0, 0, 0);
  return { webgl, camera, scene: litScene(), farol: new FarolRenderer(webgl) };
}

/** A composer of three's or of pmndrs'. */
type MakeComposer = (farol: FarolRenderer, scene: Scene, camera: Camera) => { render(): void };

/** Draws by a composer of a sample. */
function compose(make: MakeComposer): Promise<void> {
  const { farol, scene, camera } = host();
  make(farol, scene, camera).render();
  return firstFrame;
}

/** Calls what a sample exports as its user would, by its name. */
const calls: Readonly<Record<string, (exported: never) => Promise<unknown> | void>> = {
  async addLights(addLights: (scene: Scene, positionsAndRanges: Float32Array) => LightField) {
    const { farol, scene, camera } = host();
    const lights = addLights(scene, new Float32Array(4 * 10_000).fill(1)).count;
    await farol.compileAsync(scene, camera);
    farol.render(scene, camera);
    check(farol.info.lights.total > lights, `${farol.info.lights.total} lights are drawn`);
  },

  async addStones(addStones: (scene: Scene) => InstancedMesh) {
    const { farol, scene, camera } = host();
    check(addStones(scene).count === 10_000, 'stones are there');
    await farol.compileAsync(scene, camera);
    farol.render(scene, camera);
  },

  async bake(bake: (renderer: WebGLRenderer, scene: Scene, signal: AbortSignal) => Promise<void>) {
    const scene = new Scene();
    const floor = new Mesh(new PlaneGeometry(0.1, 0.1), new MeshLambertMaterial());
    const lamp = new PointLight(0xffffff, 3);
    lamp.position.z = 1;
    scene.add(floor, lamp);
    // its sizes are for a GPU: it is stopped by what it says of its progress
    const stop = new AbortController();
    console.log = () => stop.abort();
    const end = await bake(host().webgl, scene, stop.signal).then(
      () => 'all is baked',
      (error: Error) => error.name,
    );
    check(end === 'AbortError', end);
  },

  bloomByPmndrs: compose,

  bloomByThree: compose,

  burn(burn: (farol: FarolRenderer, scene: Scene, camera: Camera) => void) {
    const { farol, scene, camera } = host();
    burn(farol, scene, camera);
    return firstFrame;
  },

  async castShadows(castShadows: (webgl: WebGLRenderer, scene: Scene) => SpotLight) {
    const { webgl, farol, scene, camera } = host();
    check(castShadows(webgl, scene).castShadow, 'the lamp casts shadows');
    await farol.compileAsync(scene, camera);
    farol.render(scene, camera);
    check(farol.info.shadows.drawn + farol.info.shadows.kept === 2, 'two lights have maps');
  },

  drawAllByFarol(drawAllByFarol: (webgl: WebGLRenderer) => () => void) {
    const { webgl, scene, camera } = host();
    const stop = drawAllByFarol(webgl);
    webgl.render(scene, camera);
    stop();
    webgl.render(scene, camera);
    return firstFrame;
  },

  drawForHeadsets(draw: (farol: FarolRenderer, scene: Scene, camera: Camera) => void) {
    const { farol, scene, camera } = host();
    draw(farol, scene, camera);
    return firstFrame;
  },

  async drawOffscreen(draw: (sent: object, scene: Scene, camera: Camera) => Promise<FarolRenderer>) {
    const { scene, camera } = host();
    const sent = { canvas: new OffscreenCanvas(160, 120), width: 160, height: 120, ratio: 1 };
    await draw(sent, scene, camera);
    return firstFrame;
  },

  drawOnEach(draw: (canvases: HTMLCanvasElement[], scene: Scene, camera: Camera) => FarolRenderer[]) {
    const { scene, camera } = host();
    const canvases = [document.createElement('canvas'), document.createElement('canvas')];
    check(draw(canvases, scene, camera).length === 2, 'each canvas has a renderer');
    return firstFrame;
  },

  drawToTexture(draw: (farol: FarolRenderer, scene: Scene, camera: Camera) => WebGLRenderTarget) {
    const { farol, scene, camera } = host();
    check(draw(farol, scene, camera).samples === 4, 'a target is drawn to');
    return firstFrame;
  },

  async fogUp(fogUp: (farol: FarolRenderer, scene: Scene) => void) {
    const { farol, scene, camera } = host();
    fogUp(farol, scene);
    await farol.compileAsync(scene, camera);
    farol.render(scene, camera);
    check(farol.effects.length === 1, 'fog is an effect');
  },

  followSize(followSize: (farol: FarolRenderer, camera: Camera, parent: Element) => ResizeObserver) {
    const { farol, camera } = host();
    return new Promise((resolve) => {
      farol.setSize = (width, height) => resolve(check(width * height > 0, `its size is ${width} × ${height}`));
      followSize(farol, camera, document.querySelector('div')!);
    });
  },

  giveRange(giveRange: (light: PointLight) => void) {
    const lamp = new PointLight(0xffffff, 20);
    giveRange(lamp);
    check(lamp.distance === 20, `the range is ${lamp.distance}`);
  },

  holdFrameTime(hold: (farol: FarolRenderer) => void) {
    const { farol } = host();
    hold(farol);
    check(farol.budget?.frame === 16.7, 'a budget is set');
  },

  learnFasterTechniques(learn: (farol: FarolRenderer) => void) {
    const { farol } = host();
    learn(farol);
    check(farol.learning, 'auto learns');
  },

  async offerHeadsets(offer: (app: App) => Promise<void>) {
    const app = new App({ parent: document.body });
    await offer(app);
    app.dispose();
  },

  async makeWaves(makeWaves: (material: Material) => void) {
    const { farol, scene, camera } = host();
    makeWaves(scene.getObjectsByProperty('isMesh', true).map((mesh) => (mesh as Mesh).material as Material)[0]);
    await farol.compileAsync(scene, camera);
    farol.render(scene, camera);
  },

  moveWaves: (moveWaves: (seconds: number) => void) => moveWaves(1),

  Spin(Spin: Parameters<GameObject['addComponent']>[0]) {
    const turned = new GameObject();
    turned.addComponent(Spin).update(0.5, 2);
    check(turned.object3D.rotation.y === 2, `it is turned by ${turned.object3D.rotation.y}`);
  },

  async tellLights(tellLights: (farol: FarolRenderer, scene: Scene, camera: Camera) => Promise<void>) {
    const { farol, scene, camera } = host();
    farol.render(scene, camera);
    const told: unknown[][] = [];
    console.log = (...words) => told.push(words);
    await tellLights(farol, scene, camera);
    check(told.length > 1, 'colour and lights are told');
  },

  turn(turn: (commands: CommandStack, owners: FieldTarget[]) => void) {
    const commands = new CommandStack();
    let angle = 0;
    const owner: FieldTarget = {
      ownerName: 'Lamp',
      fields: { angle: {} },
      getAuthored: () => angle,
      set: (_name, value) => void (angle = Number(value)),
    };
    turn(commands, [owner]);
    check(angle === 0 && commands.redoLabel !== null, `the angle is ${angle}`);
  },

  shadowMaps(shadowMaps: (farol: FarolRenderer) => string[]) {
    check(shadowMaps(host().farol).length === 0, 'no map is shown');
  },

  viewMenu(viewMenu: (farol: FarolRenderer) => HTMLSelectElement) {
    const { farol } = host();
    const menu = viewMenu(farol);
    menu.value = 'normal';
    menu.dispatchEvent(new Event('change'));
    check(farol.view === 'normal', `the view is ${farol.view}`);
  },
};

async function call(load: () => Promise<object>, draws: boolean): Promise<void> {
  for (const [name, exported] of Object.entries(await load())) {
    check(Object.hasOwn(calls, name), `nothing calls "${name}": add a call to e2e/packages/samplePage.ts`);
    await calls[name](exported as never);
  }
  if (draws) await firstFrame;
}

/**
 * Runs a sample as a page would, and all that it exports; `window.problem` is then the error, or empty.
 * @param draws - whether it draws frames by itself
 */
export async function run(load: () => Promise<object>, draws: boolean): Promise<void> {
  const problem = await call(load, draws).then(() => '', String);
  Object.assign(window, { problem });
}
