import { Signal, t } from '@farol/editing';
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
import { type FarolOptions, FarolRenderer, type TechniqueName, type View } from '@farol/renderer';
import type { Camera as ThreeCamera, Scene as ThreeScene, WebGLRenderer } from 'three';
import { setDemoDecals } from './demoDecals';
import { setDemoParticles } from './demoParticles';
import { setDemoRectangles } from './demoRectangles';
import { measureScene } from './measure/measureScene';
import { loadModel, type LoadedModel } from './model/loadModel';
import { disposeModel, modelScene, modelValues } from './model/modelScene';
import { type Pixels, readPixels } from './readPixels';
import { fitSize, largestSide } from './state/fitSize';
import { known } from './state/known';
import { readState } from './state/readState';
import type { ViewerState } from './state/ViewerState';
import { writeAddress, writeState } from './state/writeState';
import { Messages } from './ui/Messages';
import { ViewerEffects } from './ViewerEffects';

/** Delay after which a message says that a model is being read (ms). */
const LONG = 1000;

/**
 * The viewer: a scene over the whole page, drawn by any technique. Its state is in the page's address; the address,
 * the menu and these methods change it. Tests and benchmarks call the methods on `window.viewer`.
 *
 * With a fixed time (`?time=`) nothing moves and no loop runs: each call that changes the picture draws one frame.
 */
export class Viewer {
  /** Resolves when the first scene is loaded and drawn. */
  readonly ready: Promise<void>;
  readonly app: App;
  readonly messages: Messages;
  readonly state: ViewerState;
  /** Scenes, techniques and views to choose from. */
  readonly known = known;

  /** Meshes and textures shared by all scenes. */
  readonly assets = new AssetLibrary();

  private model: LoadedModel | null = null;
  private loads = 0;
  private size = '';
  private readonly effects: ViewerEffects;
  private readonly stateChanged = new Signal();

  /**
   * @param parent - element that gets the canvas
   * @param search - query of the page's address
   * @throws Error when the browser has no WebGL 2
   */
  constructor(parent: HTMLElement, search: string) {
    this.messages = new Messages(parent);
    const { state, problems } = readState(search, known);
    this.state = state;
    this.messages.show('address', problems.join('\n'));
    this.app = new App({ parent });
    this.effects = new ViewerEffects(this.farol);
    this.chooseTechnique(state.technique, 'auto');
    this.chooseView(state.view, 'final');
    this.setQuality(state.quality);
    this.resize();
    new ResizeObserver(() => this.resize()).observe(parent);
    watchPixelRatio(() => this.resize());
    // effects are fetched before the first frame, which is then drawn with all of them
    this.ready = Promise.all([FarolRenderer.preload(), this.effects.fetch(this.state)]).then(() =>
      this.chooseScene(state.scene),
    );
    this.ready.catch(() => {}); // a message is displayed already; callers that await `ready` get the error too
  }

  get farol(): FarolRenderer {
    return this.app.renderer;
  }

  /** three's renderer that Farol draws with. */
  get three(): WebGLRenderer {
    return this.app.webgl;
  }

  get scene(): ThreeScene {
    return this.app.scene.three;
  }

  get camera(): ThreeCamera {
    return this.cameraComponent.three;
  }

  /** The engine's scene; its GameObjects hold the objects of `scene`. */
  get engineScene(): Scene {
    return this.app.scene;
  }

  /** Name of the dropped model; null while a scene of the engine is drawn. */
  get modelName(): string | null {
    return this.model?.name ?? null;
  }

  /** @throws Error that names the known techniques when `name` is none of them */
  setTechnique(name: string): void {
    this.farol.technique = name as TechniqueName;
    this.changed({ technique: name });
  }

  /** Draws with a technique; if the device cannot run it, draws with `otherwise` and displays a message. */
  chooseTechnique(name: string, otherwise = this.farol.technique): void {
    this.choose(name, otherwise, (one) => this.setTechnique(one));
  }

  /** Shows a view; if the device cannot draw it, shows the view `otherwise` and displays a message. */
  chooseView(name: string, otherwise = this.farol.view): void {
    this.choose(name, otherwise, (one) => this.setView(one));
  }

  /** @throws Error that names the known views when `name` is none of them */
  setView(name: string): void {
    this.farol.view = name as View;
    this.changed({ view: name });
  }

  /** @throws Error that names the known qualities when `name` is none of them */
  setQuality(name: string): void {
    this.farol.quality = name as Required<FarolOptions>['quality'];
    this.changed({ quality: name });
  }

  /** Switches the frame budget. @param name - 'on', 'off' or 'auto', which is on for touch screens */
  setBudget(name: string): void {
    this.changed({ budget: name });
  }

  /**
   * Chooses the anti-aliasing: a key of `known.antialiasing`.
   * @throws Error that names the known keys when `name` is none of them
   */
  setAntialiasing(name: string): void {
    if (!known.antialiasing.includes(name)) {
      throw new Error(`Unknown anti-aliasing "${name}". Choose one of ${known.antialiasing.join(', ')}.`);
    }
    this.changed({ aa: name });
  }

  /** Switches an effect on or off, or sets one of its numbers. @param name - key of `known.effects` */
  setEffect(name: string, value: FieldValue): void {
    this.changed({ effects: { ...this.state.effects, [name]: value } });
  }

  /** Adds the decals of the demo to the scene, or removes them. */
  setDecals(on: boolean): void {
    this.changed({ decals: on });
  }

  /** Fills the scene with `count` particles that are lights; 0 for none. */
  setParticles(count: number): void {
    this.changed({ particles: count });
  }

  /** Fills the scene with `count` rectangle lights; 0 for none. */
  setRectangles(count: number): void {
    this.changed({ rectangles: count });
  }

  /**
   * Loads and shows a scene of the engine. A later call cancels earlier ones.
   *
   * @param parameters - values of its parameters; absent ones have their defaults
   * @param keepCamera - whether the camera keeps its pose
   * @throws Error (as a rejection) when there is no such scene or a parameter is wrong; the current scene stays
   */
  async loadScene(name: string, parameters: Record<string, FieldValue> = {}, keepCamera = false): Promise<void> {
    const load = ++this.loads;
    if (!Object.hasOwn(scenes, name))
      throw new Error(`it is unknown: choose one of ${Object.keys(scenes).join(', ')}.`);
    const scene = await scenes[name].build(parameters, this.assets);
    if (load !== this.loads) return scene.dispose();
    this.replaceScene(scene, keepCamera);
    this.dropModel();
    this.changed({ scene: name, parameters: { ...this.state.parameters, ...parameters } });
  }

  /**
   * Shows a scene, or a message if it cannot be shown.
   *
   * @param parameters - values of parameters, by default the state's; those unknown to the scene are ignored
   */
  async chooseScene(name: string, keepCamera = false, parameters = this.state.parameters): Promise<void> {
    const fields = scenes[name]?.parameters ?? {};
    const known = Object.entries(parameters).filter(([parameter]) => Object.hasOwn(fields, parameter));
    try {
      await this.loadScene(name, Object.fromEntries(known), keepCamera);
      this.messages.show('scene', '');
    } catch (error) {
      const problem = error instanceof Error ? error.message : String(error);
      this.messages.show('scene', t('Scene {name}: {problem}', { name, problem }));
      throw error;
    }
  }

  /**
   * Shows the model among some files. If it cannot be read, a message says why and the current scene stays.
   *
   * @param files - a glTF or OBJ with the files that it names; a promise of them for a drop
   */
  async loadFiles(files: FileMap | Promise<FileMap>): Promise<void> {
    const load = ++this.loads;
    const cancel = new AbortController();
    const onKey = ({ key }: KeyboardEvent): void => {
      if (key === 'Escape') cancel.abort();
    };
    const timer = setTimeout(() => {
      this.messages.show('file', t('The model is being read. Escape cancels.'), () => cancel.abort());
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

  /**
   * Opens the Lab with the current scene, or displays an error. Call it from a click or key event: see `openBeside`.
   */
  async measure(): Promise<void> {
    this.messages.show('lab', '');
    try {
      await measureScene(this.app.scene, this.model, this.state);
    } catch (error) {
      this.messages.show('lab', error instanceof Error ? error.message : String(error));
    }
  }

  /** Changes parameters of the current scene; the camera keeps its pose. */
  async setParameters(parameters: Record<string, FieldValue>): Promise<void> {
    const merged = { ...this.state.parameters, ...parameters };
    if (!this.model) return this.chooseScene(this.state.scene, true, merged);
    this.state.parameters = merged;
    this.showModel(this.model, true);
  }

  /** Stops the scene at a time (s) and draws it; null resumes from the current time. */
  setTime(seconds: number | null): void {
    if (seconds !== null) this.app.scene.setTime(seconds);
    this.changed({ time: seconds });
  }

  /** Stops time at the current millisecond, or resumes it. */
  toggleTime(): void {
    this.setTime(this.state.time === null ? Math.round(this.app.scene.time * 1000) / 1000 : null);
  }

  /** Shows or hides the menu. */
  setGui(visible: boolean): void {
    this.changed({ gui: visible });
  }

  /** Draws exactly one frame, of the scene at a time (s). */
  renderAt(seconds: number): void {
    this.app.renderAt(seconds);
  }

  /** Draws the scene once with Farol and reads the picture: linear light, without tone mapping. */
  readPixels(): Pixels {
    return readPixels(this.three, () => this.farol.render(this.scene, this.camera));
  }

  /** Draws the scene once with three's own `render` and reads the picture, for comparisons. */
  readStockPixels(): Pixels {
    return readPixels(this.three, () => this.three.render(this.scene, this.camera));
  }

  /** Calls `listener` after each change of the state. @returns a function that removes the listener */
  readonly onChange = this.stateChanged.subscribe;

  /** Sizes the canvas by the state, or by the page if the state has no size; redraws if the size changed. */
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
    const fitted = fitSize(...size, largestSide(this.three.getContext()));
    this.messages.show('size', fitted.problem);
    this.app.resize(size[0], size[1], fitted.dpr);
    this.redraw();
  }

  /** Draws the scene if the loop is stopped. */
  redraw(): void {
    if (this.state.time !== null && this.app.scene.activeCamera) this.app.step(0);
  }

  private choose(name: string, otherwise: string, set: (name: string) => void): void {
    try {
      set(name);
    } catch (error) {
      this.messages.show('device', `${(error as Error).message} ${t('Shown instead: {name}.', { name: otherwise })}`);
      set(otherwise);
    }
  }

  private get cameraComponent(): CameraComponent {
    const camera = this.app.scene.activeCamera;
    if (!camera) throw new Error('The scene has no camera: wait for viewer.ready.');
    return camera;
  }

  private showModel(model: LoadedModel, keepCamera: boolean): void {
    const scene = modelScene(model, modelValues(this.state.parameters), this.assets);
    this.replaceScene(scene, keepCamera);
    if (model !== this.model) this.dropModel();
    this.model = model;
    this.changed({});
  }

  private replaceScene(scene: Scene, keepCamera: boolean): void {
    const previous = this.app.scene;
    const pose = keepCamera ? previous.activeCamera?.gameObject.object3D : null;
    const camera = scene.activeCamera?.gameObject;
    if (!camera) throw new Error(`The scene ${scene.name} has no camera: add one.`);
    if (!camera.getComponent(KeyController)) camera.addComponent(KeyController);
    if (!camera.getComponent(MouseController)) camera.addComponent(MouseController);
    if (pose) camera.transform.modelMatrix = pose.matrixWorld;
    if (this.state.time !== null) scene.setTime(this.state.time);
    setDemoDecals(scene, this.state.decals);
    setDemoParticles(scene, this.state.particles);
    setDemoRectangles(scene, this.state.rectangles);
    this.app.scene = scene;
    previous.dispose();
  }

  private dropModel(): void {
    if (this.model) disposeModel(this.model.gltf.scene);
    this.model = null;
  }

  private changed(changes: Partial<ViewerState>): void {
    Object.assign(this.state, changes);
    setDemoDecals(this.app.scene, this.state.decals);
    setDemoParticles(this.app.scene, this.state.particles);
    setDemoRectangles(this.app.scene, this.state.rectangles);
    this.app.scene.settings.frameBudget = this.state.budget as 'auto';
    this.effects.update(this.state);
    // timer queries cannot be nested: without the menu nobody reads these, and a benchmark may use its own
    this.farol.timing = this.state.gui;
    writeAddress(writeState(this.state, known, this.model === null));
    this.stateChanged.emit();
    if (!this.app.scene.activeCamera) return; // the first scene is still loading
    if (this.state.time === null) this.app.start();
    else this.app.stop();
    this.redraw();
  }
}
