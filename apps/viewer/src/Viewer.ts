import {
  App,
  AssetLibrary,
  type CameraComponent,
  KeyController,
  MouseController,
  type Scene,
  watchPixelRatio,
} from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import { cancellable, type FileMap } from '@farol/engine/files';
import { scenes } from '@farol/scenes';
import { type FarolEffect, FarolRenderer, type TechniqueName, techniques, type View, views } from '@farol/renderer';
import { loadEffects } from '@farol/renderer/effects';
import type { Camera as ThreeCamera, Scene as ThreeScene, WebGLRenderer } from 'three';
import { buildScene } from './buildScene';
import { setDemoDecals } from './demoDecals';
import { setDemoParticles } from './demoParticles';
import { setDemoRectangles } from './demoRectangles';
import { dragonUrls } from './dragonUrls';
import { measureScene } from './measure/measureScene';
import { loadModel, type LoadedModel } from './model/loadModel';
import { disposeModel, modelParameters, modelScene } from './model/modelScene';
import { type Pixels, readPixels } from './readPixels';
import { fitSize } from './state/fitSize';
import { withDefaults } from './state/withDefaults';
import { antialiasingNames, effectEntries, effectParameters, switchName } from './state/effectParameters';
import { writeAddress } from './state/writeAddress';
import { readState } from './state/readState';
import type { KnownNames, ViewerState } from './state/ViewerState';
import { writeState } from './state/writeState';
import { Messages } from './ui/Messages';

/** What the address may name, and what it means when it says nothing. */
export const known: KnownNames = {
  scenes,
  techniques: Object.keys(techniques),
  views,
  dragons: Object.keys(dragonUrls),
  antialiasing: antialiasingNames,
  effects: effectParameters,
  defaults: {
    ...{
      scene: 'temple',
      technique: 'auto',
      view: 'final',
      parameters: {},
      dragon: 'medium',
      aa: 'none',
      effects: {},
      decals: false,
      particles: 0,
      rectangles: 0,
    },
    ...{ time: null, width: null, height: null, dpr: null, gui: true },
  },
};

/** How long a model may take before a message tells of it (ms). */
const LONG = 1000;

/**
 * The thesis's App: a scene over the whole page, drawn by any technique. Its state stands in the address of the page, and
 * is changed from there, from the menu, or by these methods, which tests and benchmarks call as `window.viewer`.
 *
 * With a fixed time (`?time=`) nothing moves and no loop runs: each call draws what it says and no more.
 */
export class Viewer {
  /** Fulfilled when the first scene is loaded and drawn. */
  readonly ready: Promise<void>;
  readonly app: App;
  readonly messages: Messages;
  readonly state: ViewerState;
  /** Every scene, technique and view that may be chosen. */
  readonly known = known;

  /** Meshes and textures that all scenes share, by the resolution of the dragon in them. */
  private readonly libraries = new Map<string, AssetLibrary>();
  private model: LoadedModel | null = null;
  private loads = 0;
  private size = '';
  /** Every effect, one of each, once their code is there; those in use are in `farol.effects`. */
  private readonly allEffects = new Map<string, FarolEffect>();
  private effectNames = '';
  private readonly listeners = new Set<() => void>();

  /**
   * @param parent - what the canvas is put into
   * @param search - query of the page's address
   * @throws Error when the browser has no WebGL 2
   */
  constructor(parent: HTMLElement, search: string) {
    this.messages = new Messages(parent);
    const { state, problems } = readState(search, known);
    this.state = state;
    this.messages.show('address', problems.join('\n'));
    this.app = new App({ parent });
    this.chooseTechnique(state.technique, 'auto');
    this.chooseView(state.view, 'final');
    this.resize();
    new ResizeObserver(() => this.resize()).observe(parent);
    watchPixelRatio(() => this.resize());
    // what the first frame may need is there before it
    this.ready = Promise.all([FarolRenderer.preload(), this.fetchEffects()]).then(() => this.chooseScene(state.scene));
    this.ready.catch(() => {}); // told by a message; who waits for it hears of it too
  }

  get farol(): FarolRenderer {
    return this.app.renderer;
  }

  /** three's renderer, which Farol draws with. */
  get three(): WebGLRenderer {
    return this.app.webgl;
  }

  get scene(): ThreeScene {
    return this.app.scene.three;
  }

  get camera(): ThreeCamera {
    return this.cameraComponent.three;
  }

  /** Meshes and textures for scenes that are built now. */
  get assets(): AssetLibrary {
    const { dragon } = this.state;
    let library = this.libraries.get(dragon);
    const url = dragonUrls[dragon];
    if (!library) this.libraries.set(dragon, (library = new AssetLibrary(url ? { urls: { dragon: url } } : {})));
    return library;
  }

  /** The engine's scene, whose GameObjects made `scene`. */
  get engineScene(): Scene {
    return this.app.scene;
  }

  /** Name of the dropped model on show, or null. */
  get modelName(): string | null {
    return this.model?.name ?? null;
  }

  /** @throws Error naming the known ones when there is no such technique */
  setTechnique(name: string): void {
    this.farol.technique = name as TechniqueName;
    this.changed({ technique: name });
  }

  /** Draws by a technique, or, with a message, by another one where the device cannot. */
  chooseTechnique(name: string, otherwise = this.farol.technique): void {
    this.choose(name, otherwise, (one) => this.setTechnique(one));
  }

  /** Shows a view, or, with a message, another one where the device cannot. */
  chooseView(name: string, otherwise = this.farol.view): void {
    this.choose(name, otherwise, (one) => this.setView(one));
  }

  /** @throws Error naming the known ones when there is no such view */
  setView(name: string): void {
    this.farol.view = name as View;
    this.changed({ view: name });
  }

  /**
   * Chooses how edges are smoothed: a key of `known.antialiasing`.
   * @throws Error naming the known ones when there is no such anti-aliasing
   */
  setAntialiasing(name: string): void {
    if (!known.antialiasing.includes(name)) {
      throw new Error(`Unknown anti-aliasing "${name}". Known are ${known.antialiasing.join(', ')}.`);
    }
    this.changed({ aa: name });
  }

  /** Switches an effect on or off, or sets a number of it. @param name - a key of `known.effects` */
  setEffect(name: string, value: FieldValue): void {
    this.changed({ effects: { ...this.state.effects, [name]: value } });
  }

  /** Throws decals on the scene, or takes them away. */
  setDecals(on: boolean): void {
    this.changed({ decals: on });
  }

  /** Fills the scene with so many particles that are lights; 0 for none. */
  setParticles(count: number): void {
    this.changed({ particles: count });
  }

  /** Fills the scene with so many rectangle lights; 0 for none. */
  setRectangles(count: number): void {
    this.changed({ rectangles: count });
  }

  /** Chooses the resolution of the Stanford dragon, a key of `known.dragons`, and builds the scene on show anew. */
  async setDragon(name: string): Promise<void> {
    this.changed({ dragon: name });
    if (!this.model) await this.chooseScene(this.state.scene, true);
  }

  /**
   * Shows a scene of the engine's, when it is loaded. Of several calls that run at once the last one counts.
   *
   * @param parameters - values of its parameters; the rest have their defaults
   * @param keepCamera - look from where the present camera is
   * @throws Error (as a rejection) when there is no such scene or a parameter is wrong; the present scene stays
   */
  async loadScene(name: string, parameters: Record<string, FieldValue> = {}, keepCamera = false): Promise<void> {
    const load = ++this.loads;
    const scene = await buildScene(name, parameters, this.assets, this.three);
    if (load !== this.loads) return scene.dispose();
    this.replaceScene(scene, keepCamera);
    this.dropModel();
    this.changed({ scene: name, parameters: { ...this.state.parameters, ...parameters } });
  }

  /**
   * Shows a scene with those of some parameters that it has; a message tells when it cannot be shown.
   *
   * @param parameters - the state's by default
   */
  async chooseScene(name: string, keepCamera = false, parameters = this.state.parameters): Promise<void> {
    const fields = scenes[name]?.parameters ?? {};
    const own = Object.entries(parameters).filter(([parameter]) => Object.hasOwn(fields, parameter));
    try {
      await this.loadScene(name, Object.fromEntries(own), keepCamera);
      this.messages.show('scene', '');
    } catch (error) {
      this.messages.show('scene', `Scene ${name}: ${error instanceof Error ? error.message : String(error)}`);
      throw error;
    }
  }

  /**
   * Shows the model among some files. A message tells of files that cannot be shown; the present scene stays then.
   *
   * @param files - a glTF or OBJ, and what it names; those of a drop are on their way
   */
  async loadFiles(files: FileMap | Promise<FileMap>): Promise<void> {
    const load = ++this.loads;
    const cancel = new AbortController();
    const onKey = ({ key }: KeyboardEvent): void => {
      if (key === 'Escape') cancel.abort();
    };
    const timer = setTimeout(() => {
      this.messages.show('file', 'The model is being read. Escape cancels.', () => cancel.abort());
    }, LONG);
    addEventListener('keydown', onKey);
    try {
      const reading = Promise.resolve(files).then((all) => loadModel(all, this.three, cancel.signal));
      const model = await cancellable(reading, cancel.signal, ({ gltf }) => disposeModel(gltf.scene));
      if (load !== this.loads) return disposeModel(model.gltf.scene);
      this.showModel(model, false);
      this.messages.show('file', model.notes.join('\n'));
    } catch (error) {
      const text = error instanceof Error ? error.message : String(error);
      this.messages.show('file', cancel.signal.aborted ? '' : text);
    } finally {
      clearTimeout(timer);
      removeEventListener('keydown', onKey);
    }
  }

  /** Opens the Lab with the scene on show, or tells why not. Call it while a click or a key is answered: see `openBeside`. */
  async measure(): Promise<void> {
    this.messages.show('lab', '');
    try {
      await measureScene(this.app.scene, this.model, this.state);
    } catch (error) {
      this.messages.show('lab', error instanceof Error ? error.message : String(error));
    }
  }

  /** Changes parameters of the scene on show, and looks from where one looked before. */
  async setParameters(parameters: Record<string, FieldValue>): Promise<void> {
    const merged = { ...this.state.parameters, ...parameters };
    if (!this.model) return this.chooseScene(this.state.scene, true, merged);
    this.state.parameters = merged;
    this.showModel(this.model, true);
  }

  /** Fixes the time (s) and draws the scene as it is then; null lets time run on from where it is. */
  setTime(seconds: number | null): void {
    if (seconds !== null) this.app.scene.setTime(seconds);
    this.changed({ time: seconds });
  }

  /** Stops time where it is (to a millisecond), or lets it run on. */
  toggleTime(): void {
    this.setTime(this.state.time === null ? Math.round(this.app.scene.time * 1000) / 1000 : null);
  }

  /** Shows or hides the menu. */
  setGui(shown: boolean): void {
    this.changed({ gui: shown });
  }

  /** Draws exactly one frame, as the scene is at a time (s). */
  renderAt(seconds: number): void {
    this.app.renderAt(seconds);
  }

  /** Draws the scene once more as it is and reads the picture: linear light, without tone mapping. */
  readPixels(): Pixels {
    return readPixels(this.three, () => this.farol.render(this.scene, this.camera));
  }

  /** The same by three's own `render`, to compare with. */
  readStockPixels(): Pixels {
    return readPixels(this.three, () => this.three.render(this.scene, this.camera));
  }

  /** Calls `listener` after each change of the state. */
  onChange(listener: () => void): void {
    this.listeners.add(listener);
  }

  /** Makes the canvas as large as the state says, or as the page. Draws anew when that is another size. */
  resize(): void {
    const { width, height, dpr } = this.state;
    const parent = this.app.canvas.parentElement!;
    const size: [number, number, number] = [
      width ?? Math.max(1, parent.clientWidth),
      height ?? Math.max(1, parent.clientHeight),
      dpr ?? Math.min(devicePixelRatio, 2),
    ];
    if (size.join() === this.size) return;
    this.size = size.join();
    const fitted = fitSize(...size, this.largestSide);
    this.messages.show('size', fitted.problem);
    this.app.resize(size[0], size[1], fitted.dpr);
    this.redraw();
  }

  /** Draws the scene as it is, when no loop does. */
  redraw(): void {
    if (this.state.time !== null && this.app.scene.activeCamera) this.app.step(0);
  }

  private choose(name: string, otherwise: string, set: (name: string) => void): void {
    try {
      set(name);
    } catch (error) {
      this.messages.show('device', `${(error as Error).message} Shown instead: ${otherwise}.`);
      set(otherwise);
    }
  }

  /** Most pixels a side that the device can draw. */
  private get largestSide(): number {
    const gl = this.three.getContext();
    const [width, height] = (gl.getParameter(gl.MAX_VIEWPORT_DIMS) as Int32Array | null) ?? [];
    const asked = [gl.MAX_TEXTURE_SIZE, gl.MAX_RENDERBUFFER_SIZE].map((name) => gl.getParameter(name) as number);
    // a lost context answers null
    return Math.min(...[width, height, ...asked].map((side) => side || Infinity));
  }

  private get cameraComponent(): CameraComponent {
    const camera = this.app.scene.activeCamera;
    if (!camera) throw new Error('The scene has no camera: wait for viewer.ready.');
    return camera;
  }

  private showModel(model: LoadedModel, keepCamera: boolean): void {
    const scene = modelScene(model, withDefaults(modelParameters, this.state.parameters), this.assets);
    this.replaceScene(scene, keepCamera);
    if (model !== this.model) this.dropModel();
    this.model = model;
    this.changed({});
  }

  private replaceScene(scene: Scene, keepCamera: boolean): void {
    const before = this.app.scene;
    const pose = keepCamera ? before.activeCamera?.gameObject.object3D : null;
    const camera = scene.activeCamera?.gameObject;
    if (!camera) throw new Error(`The scene ${scene.name} has no camera.`);
    if (!camera.getComponent(KeyController)) camera.addComponent(KeyController);
    if (!camera.getComponent(MouseController)) camera.addComponent(MouseController);
    if (pose) camera.transform.modelMatrix = pose.matrixWorld;
    if (this.state.time !== null) scene.setTime(this.state.time);
    setDemoDecals(scene, this.state.decals);
    setDemoParticles(scene, this.state.particles);
    setDemoRectangles(scene, this.state.rectangles);
    this.app.scene = scene;
    before.dispose();
  }

  private dropModel(): void {
    if (this.model) disposeModel(this.model.gltf.scene);
    this.model = null;
  }

  private async fetchEffects(): Promise<void> {
    for (const [name, Effect] of Object.entries(await loadEffects())) this.allEffects.set(name, new Effect());
    this.setEffects();
  }

  /** Brings the renderer's effects up to the state. */
  private setEffects(): void {
    const { aa, effects } = this.state;
    const names: string[] = [];
    for (const [name, effect] of this.allEffects) {
      const entry = effectEntries[name];
      for (const [number, { property }] of Object.entries(entry.fields ?? {}))
        Object.assign(effect, { [property]: effects[number] ?? effectParameters[number].default });
      if (name === aa || effects[switchName(entry)] === true) names.push(name);
    }
    if (names.join() === this.effectNames) return;
    this.effectNames = names.join();
    this.farol.effects = names.map((name) => this.allEffects.get(name)!);
  }

  private changed(changes: Partial<ViewerState>): void {
    Object.assign(this.state, changes);
    setDemoDecals(this.app.scene, this.state.decals);
    setDemoParticles(this.app.scene, this.state.particles);
    setDemoRectangles(this.app.scene, this.state.rectangles);
    this.setEffects();
    // Timer queries cannot be nested: without the menu they are left to whoever measures.
    this.farol.timing = this.state.gui;
    writeAddress(writeState(this.state, known, this.model === null));
    for (const listener of this.listeners) listener();
    if (!this.app.scene.activeCamera) return; // the first scene is on its way
    if (this.state.time === null) this.app.start();
    else this.app.stop();
    this.redraw();
  }
}
