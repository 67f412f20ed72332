import { type Camera, EventDispatcher, type Object3D, type WebGLRenderer } from 'three';
import { adoptDepth } from '../three/adoptDepth';
import { checkCopy } from '../three/checkCopy';
import { drawCameras, type DrawByCamera } from './drawCameras';
import type { Session } from '../frame/Session';
import { checkDevice } from '../gpu/checkDevice';
import { qualities, type Quality } from '../gpu/isWeakDevice';
import { type View, views } from '../frame/views';
import { unknownName } from './errors';
import { NO_EFFECTS } from '../frame/ActiveEffects';
import { EffectList } from './EffectList';
import type { FarolEffect } from '../frame/FarolEffect';
import type { FarolInfo, MemoryInfo } from './FarolInfo';
import { type FarolEvents, type FarolOptions, setOptions } from './FarolOptions';
import { Frame } from '../frame/Frame';
import { InfoRecorder } from './InfoRecorder';
import { LastFrame } from './LastFrame';
import { Lazy } from '../frame/Lazy';
import { lateDraws } from './lateDraws';
import { lazyCode, type LazyPart, loadPart, warmUpCode, xrCode } from './lazyCode';
import { LazyViews } from './LazyViews';
import { LightFinder } from './LightFinder';
import type { FrameBudget } from './FrameBudget';
import { FrameLights } from './FrameLights';
import type { LightOrder } from '../lighting/LightTable';
import { resetLayers } from '../materials/layersAttribute';
import { TwinCache } from '../materials/TwinCache';
import type { MicroShaderRegistry } from '../microshaders';
import { countMemory } from './countMemory';
import type { XRDraws } from './xr/XRDraws';
import { createRegistry } from './createRegistry';
import { updateCamera } from './sceneCallbacks';
import { SceneDraws } from './SceneDraws';
import { SceneView } from './SceneView';
import type { TechniqueName } from '../techniques';
import type { Technique } from '../frame/Technique';
import { TechniquePicker } from './TechniquePicker';
import { TechniqueSet } from './TechniqueSet';

/** Up to this many draws, and as many lights, `gl.flush()` costs more than it gains. */
const FEW = 16;

/**
 * Draws three.js scenes with any number of lights, in place of `WebGLRenderer.render`: the same scene, camera, materials,
 * lights, render target and picture.
 *
 * @example
 * const farol = new FarolRenderer(webglRenderer, { technique: 'deferred' });
 * farol.render(scene, camera);
 */
export class FarolRenderer extends EventDispatcher<FarolEvents> implements Required<FarolOptions> {
  /** Parts of the code that are fetched when a scene or setting first needs them, by the names that `preload` takes. */
  static readonly parts: readonly LazyPart[] = lazyCode.map(({ name }) => name);
  /** Microshaders, pieces of GLSL, of all draws; replacing one changes the next frame. */
  readonly microshaders: MicroShaderRegistry;
  declare timing: boolean;
  declare heatMapMaximum: number;
  declare shadowAtlasSize: number | null;
  declare shadowCascades: number;
  declare lightLayers: boolean;
  declare antialias: boolean;
  declare learning: boolean;
  declare areaLightThreshold: number;
  private readonly frame: Frame;
  private readonly lights = new FrameLights();
  private readonly twins: TwinCache;
  private readonly last = new LastFrame(() => this.disposed || this.dispatchEvent({ type: 'redraw' }));
  private readonly recorder: InfoRecorder;
  private readonly sceneViews = new WeakMap<Object3D, SceneView>();
  private readonly views: LazyViews;
  private readonly finder: LightFinder;
  private readonly set: TechniqueSet;
  private readonly picker: TechniquePicker;
  private viewName: View = 'final';
  private xr: XRDraws | null = null;
  private disposed = false;
  private isDrawing = false; // true within `render`: nested calls, made by the host's callbacks, are drawn by three
  private session: Session | null = null; // set by `@farol/renderer/pixel-lighting` while that draws; else null
  private readonly effectList: EffectList;
  private readonly draws: SceneDraws;
  private readonly begun = () => this.frame.takeOutputBuffer();

  /**
   * @param webgl - the host's renderer; the host still owns it, and other code may draw with it
   * @throws Error when it is no WebGLRenderer with WebGL 2, the device lacks what the technique needs, or an option is wrong
   */
  constructor(
    readonly webgl: WebGLRenderer,
    options: FarolOptions = {},
  ) {
    super();
    checkDevice(webgl, false);
    checkCopy(webgl);
    this.effectList = new EffectList(webgl);
    this.microshaders = createRegistry(webgl);
    this.views = new LazyViews(this.microshaders);
    const uniforms = this.lights.uniforms.values;
    this.finder = new LightFinder(
      webgl,
      (code) => code.makeShadowMaps(this.frame, this.draws),
      (code) => code.makeAreaLights(webgl, this.microshaders, uniforms.farol_ltc),
    );
    this.set = new TechniqueSet(this.microshaders);
    this.picker = new TechniquePicker(webgl, this.set);
    this.twins = new TwinCache({
      uniforms,
      microshaders: this.microshaders,
      refuse: (source) => this.frame.queue.refused.refuse(source),
    });
    const late = lateDraws(this.microshaders);
    this.frame = new Frame(webgl, this.lights.table, this.twins, uniforms, this.microshaders, late);
    const { frame, views, set, picker } = this;
    const count = (memory: MemoryInfo) => countMemory(memory, frame, set, this.finder, this.draws, views, this.effects);
    this.recorder = new InfoRecorder(webgl, this.last, count);
    this.draws = new SceneDraws(frame, this.recorder, views, set, picker, uniforms.farol_background.value);
    setOptions(this, options);
    webgl.getContext().canvas.addEventListener('webglcontextlost', this.free);
  }

  /** Key of the technique. @throws Error when set to an unknown one, or one that the device cannot run */
  get technique(): TechniqueName {
    return this.picker.technique;
  }

  set technique(name: TechniqueName) {
    this.picker.technique = name;
  }

  /** Techniques that `technique` may name: the built-in ones, and those that were added. */
  get techniques(): Readonly<Record<string, Technique>> {
    return this.set.known;
  }

  /**
   * Adds a technique to this renderer.
   * @returns its name, for `technique`
   * @throws Error when a technique has that name already
   */
  addTechnique(name: string, technique: Technique): TechniqueName {
    this.set.add(name, technique);
    return name as TechniqueName;
  }

  /**
   * Removes an added technique and frees its passes. If it is in use, 'auto' takes its place.
   * @throws Error when none was added by that name
   */
  removeTechnique(name: string): void {
    this.set.remove(name);
    if (this.technique === name) this.technique = 'auto';
  }

  /** @throws Error when set to anything but a list of effects, or to conflicting ones, such as two that move the camera */
  get effects(): readonly FarolEffect[] {
    return this.effectList.hostEffects;
  }

  set effects(effects: readonly FarolEffect[]) {
    this.effectList.hostEffects = effects;
  }

  /** @throws Error when set to an unknown view */
  get view(): View {
    return this.viewName;
  }

  set view(name: View) {
    if (!views.includes(name)) throw unknownName('view', name, views);
    if (name !== 'final') checkDevice(this.webgl, true);
    this.viewName = name;
    this.views.available(name); // begins to fetch the code of the view
  }

  /** @throws Error when set to an unknown quality */
  get quality(): Quality {
    return this.frame.quality;
  }

  set quality(name: Quality) {
    if (!qualities.includes(name)) throw unknownName('quality', name, qualities);
    this.frame.quality = name;
  }

  /** @throws RangeError for a value that a budget cannot have */
  get budget(): FrameBudget | null {
    return this.draws.budget;
  }

  set budget(budget: FrameBudget | null) {
    this.draws.budget = budget;
  }

  /** @throws RangeError unless above 0 and at most 1 */
  get inferredScale(): number {
    return this.frame.inferredScale;
  }

  set inferredScale(scale: number) {
    if (scale > 0 && scale <= 1) this.frame.inferredScale = scale;
    else throw new RangeError(`FarolRenderer: inferredScale is ${scale}; give a number above 0 and at most 1.`);
  }

  /**
   * Fulfilled when the last frame had all code and programs that it needed and 'auto' is not changing technique: the same scene
   * drawn again gives the same picture, except for effects that gather frames. Each read returns a new promise. It waits for
   * the host's next frame if none was drawn yet, if code was missing, or if the context was lost. Hosts that draw on demand
   * draw again on the event 'redraw'. Rejected when a part of the code cannot be fetched, with an Error that names the part and
   * the remedy (later frames and calls try again), and when this renderer is disposed.
   */
  get ready(): Promise<void> {
    return warmUpCode.load().then((code) => code.whenReady(this.last, this.picker, () => this.disposed));
  }

  /** Figures of the last frame. */
  get info(): FarolInfo {
    return this.recorder.info;
  }

  /**
   * Draws to the current render target, viewport and scissor of the WebGLRenderer, as its own `render` would. A nested call,
   * from a host's callback while this renderer draws, is drawn by three.
   * @param scene - a Scene, or any object
   * @param camera - perspective, orthographic, or an array of them with viewports; its world matrix is updated if it has no
   *   parent. While an XR session presents, each eye draws, and the camera follows the head, as in three
   */
  render(scene: Object3D, camera: Camera): void {
    if (this.disposed) throw new Error('FarolRenderer: render() after dispose(); make a new FarolRenderer.');
    const { webgl } = this;
    if (webgl.getContext().isContextLost()) return;
    if (this.isDrawing) return webgl.render(scene, camera);
    this.isDrawing = true;
    const outer = this.last.begin();
    try {
      if (webgl.xr.enabled) this.xr ??= xrCode.use((code) => new code.XRDraws(webgl));
      if (!webgl.xr.enabled || !webgl.xr.isPresenting) drawCameras(webgl, scene, camera, this.session, this.drawScene);
      else if (this.xr === null) webgl.render(scene, camera);
      else this.xr.render(scene, camera, this.drawScene);
      this.last.end();
    } finally {
      Lazy.lacking = outer;
      this.isDrawing = false;
      if (this.disposed) this.end(); // disposed by a host's callback during the frame
    }
  }

  private readonly drawScene: DrawByCamera = (scene, camera, update, updatesCamera, seenBy, session): void => {
    if (this.disposed) return; // disposed by a host's callback while an earlier camera of the array was drawn
    const eye = session?.eye ?? 0;
    this.recorder.begin(this.timing, eye);
    this.twins.begin();
    const byThree = this.frame.queue.refused.begin(scene);
    if (eye === 0) this.finder.find(scene, seenBy, this.lightLayers, update, byThree);
    if (updatesCamera) updateCamera(camera);
    adoptDepth(this.webgl, camera);
    const { draws, finder, frame, picker, webgl } = this;
    frame.begin(scene, camera, seenBy, this.views.available(this.viewName), session);
    if (frame.view === 'grid') frame.quarter();
    const { shadows } = finder;
    const { target, face, level } = frame;
    const { toneMapping } = webgl;
    let done = false;
    const effects = frame.view === 'final' ? this.effectList.of(target, session) : NO_EFFECTS;
    const sceneView = this.viewOf(scene);
    draws.begin(sceneView, effects, this);
    try {
      this.info.budget = draws.scale();
      for (const effect of effects.all) effect.begin?.(frame);
      this.lights.update(scene, frame, finder, this, effects.all.length > 0, this.pickTechnique);
      const { fills = 'behind' } = this.set.known[picker.active];
      sceneView.render(
        frame.camera,
        finder.found.nested,
        finder.found.rest,
        frame.queue,
        draws.draw,
        frame.view === 'final' && frame.ownsTarget() ? fills : null,
        shadows,
        frame.camera === camera && !webgl.xr.enabled,
      );
      shadows?.end();
      done = true;
    } finally {
      draws.end();
      if (frame.queue.layers !== 0) resetLayers(frame.gl);
      // three takes tone mapping off while it draws to its output buffer
      if (!done) webgl.toneMapping = toneMapping;
      if (!done || webgl.getRenderTarget() !== target) webgl.setRenderTarget(target, face, level);
      this.recorder.endPass();
    }
    // the flush starts the GPU while the host continues; it is a call to another process, too slow for small frames
    const lights = frame.lights.total + (frame.fields?.count ?? 0);
    if (Math.max(this.info.drawCalls, lights) > FEW) frame.gl.flush();
    this.recorder.end(picker.active, picker.reason, frame, shadows);
    // until the code of node materials is loaded, three draws the whole frame
    if (frame.lacksNodes) webgl.render(scene, camera);
    // draws anew: with three's lights if a shader has no place for the light loop, or since the page changed shaders
    if (!frame.queue.refused.end(scene, byThree || finder.left.all) && !this.twins.isOutdated) return;
    if (session !== null) session.eye = 0; // 0: collects the lights again, as for the first eye
    this.drawScene(scene, camera, false, false, seenBy, session);
  };

  /**
   * Sizes the canvas as `WebGLRenderer.setSize` does; Farol's own targets follow the size of the target drawn to.
   * @param width - CSS pixels, as `height`
   * @param updateStyle - whether the canvas' style is set too. Default true, as in three
   */
  setSize(width: number, height: number, updateStyle?: boolean): void {
    this.webgl.setSize(width, height, updateStyle);
  }

  /** Sets the WebGLRenderer's pixel ratio. */
  setPixelRatio(ratio: number): void {
    this.webgl.setPixelRatio(ratio);
  }

  /**
   * Fetches code ahead, for all renderers of the page, that `render` else fetches when first needed. In brackets, until then:
   * Shadow maps, cookies and light layers (three draws those of up to four lights, further lights have none, and light layers
   * are ignored), area lights (three draws them as rectangles), light fields (they light nothing), anti-aliasing of techniques
   * with a G-buffer (edges are not smooth), node materials and arrays of cameras (three draws them), views of surfaces,
   * overdraw and buffers (the final picture is shown), techniques other than 'deferred' and 'forward-single-pass', and the
   * rules of 'auto' (the scene's last technique draws, or one of these two), GPU times, frame budgets.
   * @param parts - names of `FarolRenderer.parts`. Default all
   * @throws Error when there is no such part, or the code cannot be fetched
   */
  static async preload(parts: readonly LazyPart[] = FarolRenderer.parts): Promise<void> {
    await Promise.all(parts.map(loadPart));
  }

  /** Fetches all late code and adds its microshaders to `microshaders`, where they can be read and replaced. */
  async addLazyMicroShaders(): Promise<void> {
    return warmUpCode.load().then((code) => code.addLazyMicroShaders(this.microshaders, lazyCode));
  }

  /**
   * Writes GPU times that have arrived since the last `render` to `info`, as each `render` does first.
   * @returns whether any had arrived
   */
  updateTimes(): boolean {
    return this.recorder.updateTimes();
  }

  /**
   * Fetches the code and compiles the programs that the next frame of this scene needs, so that its picture is complete and it
   * does not hitch: draws frames of one pixel until no code is missing, and waits until the device has linked their programs.
   * @throws Error when the code cannot be fetched
   */
  async compileAsync(scene: Object3D, camera: Camera): Promise<void> {
    return warmUpCode.load().then((code) => code.compileByDrawing(this, this.last, this.finder, scene, camera));
  }

  /** Frees all GPU resources of Farol, not the host's. A call within `render` frees them when the frame ends. */
  dispose(): void {
    if (this.disposed) return;
    this.disposed = true;
    this.webgl.getContext().canvas.removeEventListener('webglcontextlost', this.free);
    if (!this.isDrawing) this.end();
  }

  private end(): void {
    this.free();
    for (const effect of this.effects) effect.dispose();
    this.recorder.dispose();
    this.last.tell();
  }

  /**
   * Frees the GPU resources; the next frame creates them again. Also called when the context is lost: if resources were
   * disposed only once it is restored, three would delete old handles in the new context.
   */
  private readonly free = (): void => {
    this.last.isDrawn = false;
    this.set.dispose();
    if (!this.disposed) this.effectList.dispose();
    this.draws.dispose();
    this.views.dispose();
    this.twins.dispose();
    this.lights.dispose(this.frame);
    this.finder.dispose();
  };

  /** Picks the technique by the visible lights. @returns order in which the technique needs the lights */
  private readonly pickTechnique = (): LightOrder => {
    const { draws, frame, picker } = this;
    picker.pick(draws.sceneView, frame, frame.lights, draws.effects);
    const technique = this.set.known[picker.active];
    const { all } = (draws.effects = draws.effectsOf(picker.active));
    for (const effect of all) effect.picked?.(frame, technique);
    frame.readsFew = technique.readsFew === true && all.length === 0 && frame.view === 'final';
    return technique.lightOrder;
  };

  private viewOf(scene: Object3D): SceneView {
    let view = this.sceneViews.get(scene);
    if (view === undefined) this.sceneViews.set(scene, (view = new SceneView(this.webgl, scene, this.begun)));
    return view;
  }
}
