import { type ArrayCamera, type Camera, type Object3D, Vector4, type WebGLRenderer } from 'three';
import { adoptDepth } from './adoptDepth';
import { clearValue } from './clearValue';
import { checkDevice, hasFloatTargets } from './checkDevice';
import { collectLights, type FoundLights } from './collectLights';
import type { ViewPasses } from './debug';
import { type View, isSurfaceView, isTechniqueView, views } from './debug/views';
import { unknownName } from './errors';
import type { FarolEffect } from './FarolEffect';
import type { FarolInfo } from './FarolInfo';
import { Frame } from './Frame';
import { InfoRecorder } from './InfoRecorder';
import { lightBufferCode, shadowCode, timerCode, viewCode } from './late';
import { LightTable } from './lights/LightTable';
import { forwardTwins } from './materials/forwardTwin';
import { resetLayers } from './materials/layersAttribute';
import { TwinCache } from './materials/TwinCache';
import type { MicroShaderRegistry } from './microshaders';
import { addMicroShaders } from './microshaders/addMicroShaders';
import { createRegistry } from './microshaders/createRegistry';
import { gridUniforms } from './passes/LightGridPass';
import { tileUniforms } from './passes/LightTilesPass';
import { drawEarly } from './passes/drawEarly';
import { drawPasses } from './passes/drawPasses';
import type { Pass } from './passes/Pass';
import { validatePasses } from './passes/validatePasses';
import { refuseXR } from './refuseXR';
import { renderArray } from './renderArray';
import { SceneView } from './SceneView';
import { maskUniforms } from './shadows/maskUniforms';
import type { ShadowMaps } from './shadows/ShadowMaps';
import { type TechniqueName, techniques } from './techniques';
import type { Technique } from './techniques/Technique';

export interface FarolOptions {
  /** Key of `techniques`. Default 'auto'. */
  technique?: TechniqueName;
  /** Default 'final'. */
  view?: View;
  /** Times each pass on the GPU where the device can. Default false: a host may time with a query of its own. */
  timing?: boolean;
  /** Default none. */
  effects?: readonly FarolEffect[];
  /**
   * Texels a side of the texture that holds all shadow maps, at most; it is made as large as the lights ask for. Default
   * 8192, at most what the device has; at least 512.
   */
  shadowAtlasSize?: number;
  /** As the property of that name. Default false. */
  lightLayers?: boolean;
}

const NO_EFFECTS: readonly FarolEffect[] = [];

/** Draws that cost less than having the GPU begin with them. */
const FEW_DRAWS = 16;

/** Lights with a shadow or an image that three has texture units for; more go without until Farol draws them. */
const FEW_MASKS = 4;

/**
 * Draws three.js scenes with any number of lights, in place of `WebGLRenderer.render`: the same scene, camera, materials,
 * lights, render target and picture.
 *
 * @example
 * const farol = new FarolRenderer(webglRenderer, { technique: 'deferred' });
 * farol.render(scene, camera);
 */
export class FarolRenderer {
  /** The shader pieces everything is drawn with; replace one and the picture follows. */
  readonly microshaders: MicroShaderRegistry;
  /** Times each pass on the GPU (EXT_disjoint_timer_query_webgl2). */
  timing: boolean;
  /** Lights a pixel (or draws a pixel) that the count views show hottest. Default 32, above 0. */
  heatMapMaximum = 32;
  /**
   * Shadow maps of each directional light, 1 to 4: the last is the light's own, those before it see what is near the camera,
   * each a quarter as far as the next, in maps of the same size. Not for VSMShadowMap. Default 1, as in three.
   */
  shadowCascades = 1;
  /**
   * What takes part in the frame beside the technique, in this order: anti-aliasing, ambient occlusion, decals and the like,
   * from entries of the package of their own. Takes effect on the next frame; effects that are left out stay the host's to
   * dispose, those in the list are disposed with this renderer. Default none.
   */
  effects: readonly FarolEffect[];
  private readonly frame: Frame;
  private readonly lights = new LightTable();
  /** Null until a scene has asked for what masks lights, and its code is there. */
  private shadows: ShadowMaps | null = null;
  private readonly left = { shadows: false, cookies: true };
  private readonly twins: TwinCache;
  private readonly recorder: InfoRecorder;
  private readonly uniforms = {
    farol_lightTable: { value: null as unknown },
    farol_lightCounts: { value: [0, 0, 0, 0] },
    farol_ambient: { value: this.lights.ambient },
    farol_lightIndex: { value: 0 },
    farol_heatScale: { value: 1 / 32 },
    farol_background: { value: new Vector4(0, 0, 0, -1) },
    ...maskUniforms(),
    ...tileUniforms(),
    ...gridUniforms(),
  };
  private readonly sceneViews = new WeakMap<Object3D, SceneView>();
  private readonly passLists = new Map<TechniqueName, Pass[]>();
  /** What is seen through transmissive things is drawn at another size than the lists are for. */
  private readonly transmittedTwins = forwardTwins('lightLoopAll');
  /** Null until a view has asked for them, and their code is there. */
  private viewPasses: ViewPasses | null = null;
  private readonly found: FoundLights = { all: [], count: 0, nested: [], seeksMasks: true, masks: 0 };
  private readonly known: Record<string, Technique> = { ...techniques };
  private techniqueName: TechniqueName = 'auto';
  /** What draws this frame: the technique, or what 'auto' picked, and why. */
  private active: TechniqueName = 'deferred';
  private reason = '';
  private readonly lightingScale = { value: 0.5 };
  private floatTargets = true;
  private viewName: View = 'final';
  private sceneView!: SceneView;
  private disposed = false;
  private separatesLayers = false;
  private readonly shadowAtlasSize: number;
  private activeEffects = NO_EFFECTS;
  private readonly draw = () => this.drawFrame();
  private readonly begun = () => this.frame.takeOutputBuffer();
  private readonly shadowDraws = {
    stands: [] as readonly Object3D[],
    render: () => this.run('shadow maps', () => this.shadows!.render()),
  };

  /**
   * @param webgl the host's renderer; it stays the host's, and other code may draw with it
   * @throws Error when the device has no WebGL 2 or lacks what the technique needs, or an option is unknown
   */
  constructor(
    readonly webgl: WebGLRenderer,
    options: FarolOptions = {},
  ) {
    checkDevice(webgl, false);
    this.floatTargets = hasFloatTargets(webgl);
    this.microshaders = createRegistry(webgl);
    this.twins = new TwinCache({
      uniforms: this.uniforms,
      header: (chunks) => this.microshaders.header(chunks),
      revision: (chunks) => this.microshaders.revision(chunks),
    });
    this.frame = new Frame(webgl, this.lights, this.twins, this.uniforms, this.microshaders);
    this.recorder = new InfoRecorder(webgl);
    this.shadowAtlasSize = Math.max(512, options.shadowAtlasSize ?? 8192);
    this.timing = options.timing ?? false;
    this.lightLayers = options.lightLayers ?? false;
    this.technique = options.technique ?? 'auto';
    this.view = options.view ?? 'final';
    this.effects = options.effects ?? [];
  }

  /** Key of the technique; takes effect on the next frame. @throws Error when unknown, or the device cannot run it */
  get technique(): TechniqueName {
    return this.techniqueName;
  }

  set technique(name: TechniqueName) {
    if (!Object.hasOwn(this.known, name)) throw unknownName('technique', name, Object.keys(this.known));
    checkDevice(this.webgl, this.known[name].needsFloatTargets);
    this.techniqueName = name;
  }

  /** What `technique` can be: the built-in ones, and those that were added. */
  get techniques(): Readonly<Record<string, Technique>> {
    return this.known;
  }

  /**
   * Adds a technique to this renderer.
   * @returns its name, as `technique` takes it
   * @throws Error when there is one of that name
   */
  addTechnique(name: string, technique: Technique): TechniqueName {
    if (Object.hasOwn(this.known, name)) throw new Error(`Farol: there is a technique "${name}"; choose another name.`);
    this.known[name] = technique;
    return name as TechniqueName;
  }

  /** What is shown; takes effect on the next frame. @throws Error when unknown */
  get view(): View {
    return this.viewName;
  }

  set view(name: View) {
    if (!views.includes(name)) throw unknownName('view', name, views);
    if (name !== 'final') checkDevice(this.webgl, true);
    this.viewName = name;
  }

  /**
   * Texels of the lighting buffers of the technique 'inferred' a pixel of the picture, along a side; takes effect on the next
   * frame. Default 0.5.
   * @throws RangeError unless above 0 and at most 1
   */
  get inferredScale(): number {
    return this.lightingScale.value;
  }

  set inferredScale(scale: number) {
    if (!(scale > 0 && scale <= 1)) {
      throw new RangeError(`FarolRenderer: inferredScale is ${scale}; give a number above 0 and at most 1.`);
    }
    this.lightingScale.value = scale;
  }

  /**
   * Whether a directional, point or spot light reaches only objects that share a layer with it (`light.layers`,
   * `object.layers`); a light is lit at all if the camera shares a layer with it, as in three. What has other layers than
   * most objects is then drawn forward, by every technique. Takes effect on the next frame. Default false, as in three: all
   * lights reach all objects.
   */
  get lightLayers(): boolean {
    return this.separatesLayers;
  }

  set lightLayers(enabled: boolean) {
    this.separatesLayers = enabled;
  }

  /** Figures of the last frame. */
  get info(): FarolInfo {
    return this.recorder.info;
  }

  /**
   * Draws to the current render target, viewport and scissor of the WebGLRenderer, as its own `render` would.
   * @param scene a Scene, or any object
   * @param camera perspective, orthographic, or an array of them with viewports; its world matrix is updated if it has no parent
   * @throws Error while an XR session presents
   */
  render(scene: Object3D, camera: Camera): void {
    if (this.disposed) throw new Error('FarolRenderer: render() after dispose(); make a new FarolRenderer.');
    if (this.webgl.getContext().isContextLost()) return;
    refuseXR(this.webgl);
    if ((camera as ArrayCamera).isArrayCamera === true) {
      renderArray(this.webgl, camera as ArrayCamera, (one) => this.render(scene, one));
      return;
    }
    this.recorder.begin(this.timing);
    if (scene.matrixWorldAutoUpdate) scene.updateMatrixWorld();
    if (camera.parent === null && camera.matrixWorldAutoUpdate) camera.updateMatrixWorld();
    adoptDepth(this.webgl, camera);
    this.findLights(scene, camera);
    const { frame, shadows, webgl } = this;
    frame.begin(scene, camera, this.viewToDraw());
    if (frame.view === 'grid') frame.quarter();
    const { target, face, level } = frame;
    this.activeEffects = frame.view === 'final' ? this.effects : NO_EFFECTS;
    try {
      for (const effect of this.activeEffects) effect.begin?.(frame);
      this.lights.shadows = webgl.shadowMap.enabled;
      this.lights.layers?.begin(scene, this.separatesLayers);
      this.lights.collect(this.found.all, frame.camera);
      this.lights.layers?.end();
      this.sceneView = this.viewOf(scene);
      this.pick();
      if (shadows !== null) shadows.cascades = Math.min(4, Math.max(1, Math.round(this.shadowCascades)));
      shadows?.update(scene, frame.camera, this.lights.masked);
      frame.shadowMapsDrawn = shadows?.drawn ?? 0;
      frame.queue.layers = this.lights.layers?.reference ?? 0;
      this.lights.write(frame.camera, this.known[this.active].lightOrder, frame, shadows);
      this.setUniforms();
      const { fills = 'behind' } = this.known[this.active];
      this.sceneView.render(
        frame.camera,
        this.found.nested,
        frame.queue,
        this.draw,
        frame.ownsTarget() ? fills : null,
        shadows?.hasWork ? this.shadowDraws : null,
      );
      shadows?.end();
      if (frame.queue.layers !== 0) resetLayers(frame.gl);
    } finally {
      if (webgl.getRenderTarget() !== target) webgl.setRenderTarget(target, face, level);
    }
    // lets the GPU begin while the host goes on; a call to another process, which few draws are not worth
    if (this.info.drawCalls > FEW_DRAWS) frame.gl.flush();
    this.recorder.end(this.active, this.reason, this.lights, shadows, frame.uploadedBytes, this.targetBytes());
  }

  /** Sizes the WebGLRenderer's canvas buffer (CSS pixels); Farol's own targets follow what is drawn to. */
  setSize(width: number, height: number): void {
    this.webgl.setSize(width, height, false);
  }

  /**
   * Fetches all code that `render` else asks for when a scene or setting first needs it, for all renderers of the page:
   * shadow maps, cookies and light layers (until they are there three draws the shadows and maps of up to four such lights
   * itself, more go without, and layers are not looked at), the views of surfaces and overdraw (the final picture is shown),
   * 'light-prepass' and 'inferred' ('deferred' draws).
   * @throws Error when the code cannot be fetched
   */
  static async preload(): Promise<void> {
    await Promise.all([shadowCode.load(), viewCode.load(), lightBufferCode.load(), timerCode.load()]);
  }

  /** Adds the microshaders of all code that is fetched late to `microshaders`, where they can be seen and replaced. */
  async addLateMicroShaders(): Promise<void> {
    await FarolRenderer.preload();
    for (const { code } of [shadowCode, viewCode, lightBufferCode])
      addMicroShaders(this.microshaders, code!.microShaders);
  }

  /**
   * Takes the GPU times of the last frame that have come since into `info`; `render` does so for the frames before it.
   * @returns whether there were any
   */
  updateTimes(): boolean {
    return this.recorder.updateTimes();
  }

  /**
   * Compiles what the next frame of this scene needs, so that it does not hitch: draws a frame of one pixel, and waits
   * until the device has linked its programs.
   */
  async compileAsync(scene: Object3D, camera: Camera): Promise<void> {
    this.findLights(scene, camera);
    if (this.asksForShadows && this.shadows === null) await shadowCode.load();
    await this.known[this.techniqueName].late?.load();
    const { compileByDrawing } = await import('./compileByDrawing');
    await compileByDrawing(this, scene, camera);
  }

  /** Frees all GPU resources of Farol; the host's stay. */
  dispose(): void {
    if (this.disposed) return;
    this.disposed = true;
    for (const passes of this.passLists.values()) for (const pass of passes) pass.dispose();
    this.passLists.clear();
    for (const effect of this.effects) effect.dispose();
    this.viewPasses?.overdraw.dispose();
    this.viewPasses?.surfaceView.dispose();
    this.twins.dispose();
    this.lights.dispose();
    this.shadows?.dispose();
    this.recorder.dispose();
  }

  private findLights(scene: Object3D, camera: Camera): void {
    this.left.cookies = this.shadows === null;
    this.left.shadows = this.left.cookies && this.webgl.shadowMap.enabled;
    collectLights(scene, camera, this.left, this.found);
    if (this.shadows !== null || !this.asksForShadows) return;
    if (!this.makeShadows()) {
      if (this.found.masks <= FEW_MASKS) return;
      this.left.shadows = this.left.cookies = false;
    }
    collectLights(scene, camera, this.left, this.found);
  }

  private get asksForShadows(): boolean {
    return this.found.masks > 0 || this.separatesLayers;
  }

  /** The view to be drawn: the final picture while the code of the one asked for is not there. */
  private viewToDraw(): View {
    const { viewName } = this;
    if (this.viewPasses !== null || isTechniqueView(viewName)) return viewName;
    if (viewCode.code === null) {
      viewCode.ask();
      return 'final';
    }
    this.viewPasses = viewCode.code.makeViewPasses(this.microshaders);
    return viewName;
  }

  /** Makes what masks lights, once its code is there. @returns whether it did */
  private makeShadows(): boolean {
    const { code } = shadowCode;
    if (code === null) {
      shadowCode.ask();
      return false;
    }
    this.shadows = code.makeShadowMaps(this.webgl, this.microshaders, this.shadowAtlasSize);
    this.lights.layers = this.shadows.layers;
    this.shadowDraws.stands = this.shadows.stands;
    this.frame.queue.shadowMasks = code.shadowMasks;
    this.left.shadows = this.left.cookies = this.found.seeksMasks = false;
    return true;
  }

  private pick(): void {
    const { lights } = this;
    this.active = this.techniqueName;
    this.reason = 'asked for';
    const { late } = this.known[this.active];
    if (late?.code === null) {
      late.ask();
      this.active = 'deferred';
      this.reason = `the code of "${this.techniqueName}" is being fetched`;
    }
    if (this.techniqueName !== 'auto') return;
    const { bounded, coverage, directional, unbounded } = lights;
    let surfaces = false;
    for (const effect of this.activeEffects) surfaces ||= effect.needsSurfaces === true;
    const choice = this.sceneView.chooser.choose({
      bounded,
      coverage,
      everywhere: directional + unbounded,
      transparents: this.frame.queue.hasLitTransparents,
      floatTargets: this.floatTargets,
      surfaces,
    });
    this.active = choice.technique;
    this.reason = surfaces ? 'an effect works on its G-buffer' : choice.reason;
  }

  private setUniforms(): void {
    const { lights, uniforms } = this;
    lights.upload(this.webgl);
    uniforms.farol_lightTable.value = lights.table.texture;
    uniforms.farol_offset.value.set(this.frame.viewport.x, this.frame.viewport.y);
    const counts = uniforms.farol_lightCounts.value;
    counts[0] = lights.directional;
    counts[1] = lights.unbounded;
    counts[2] = lights.bounded;
    counts[3] = lights.others;
    this.shadows?.setUniforms(uniforms, lights);
    uniforms.farol_heatScale.value = 1 / this.heatMapMaximum;
  }

  /** Called inside three's render, for the host's target, and before that for three's transmission target if needed. */
  private drawFrame(): void {
    const { frame } = this;
    if (this.webgl.getRenderTarget() !== frame.target) {
      for (const item of frame.queue.opaque) frame.drawForward(item, this.transmittedTwins('final'));
      return;
    }
    this.sceneView.dropTransmissive();
    this.setBackground();
    frame.overdraw = null;
    if (isSurfaceView(frame.view)) {
      this.showSurface();
      frame.bindTarget();
      return;
    }
    if (frame.view === 'overdraw')
      this.run('overdraw', () => this.viewPasses!.overdraw.render(frame, this.hasPass('depth')));
    drawEarly(frame, this.transmittedTwins('final'));
    drawPasses(frame, this.passesOf(this.active), this.activeEffects, this.recorder);
    if (frame.view === 'overdraw' && !this.hasPass('output')) this.viewPasses!.overdraw.show(frame);
    if (frame.view === 'grid') this.showSurface();
    frame.bindTarget();
  }

  /** What a technique that fills the target writes where nothing is: what three would have cleared it to. */
  private setBackground(): void {
    const { frame } = this;
    const background = this.uniforms.farol_background.value;
    frame.fills = this.sceneView.uncleared;
    if (frame.fills !== null) clearValue(this.webgl, frame.scene, frame.premultiplied, background);
    else background.w = -1;
  }

  private showSurface(): void {
    this.run('view', () => this.viewPasses!.surfaceView.render(this.frame));
  }

  private run(name: string, render: () => void): void {
    this.recorder.beginPass(name);
    render();
    this.recorder.endPass();
  }

  private hasPass(name: string): boolean {
    return this.passesOf(this.active).some((pass) => pass.name === name);
  }

  private passesOf(name: TechniqueName): Pass[] {
    let passes = this.passLists.get(name);
    if (passes === undefined) {
      passes = this.known[name].passes({
        microshaders: this.microshaders,
        lightIndex: this.uniforms.farol_lightIndex,
        tiles: this.uniforms,
        grid: this.uniforms,
        inferredScale: this.lightingScale,
      });
      validatePasses(name, passes);
      this.passLists.set(name, passes);
    }
    return passes;
  }

  private viewOf(scene: Object3D): SceneView {
    let view = this.sceneViews.get(scene);
    if (view === undefined) {
      view = new SceneView(this.webgl, scene, this.left, this.begun);
      this.sceneViews.set(scene, view);
    }
    return view;
  }

  private targetBytes(): number {
    let bytes = this.lights.bytes + (this.shadows?.bytes ?? 0);
    if (this.viewPasses !== null) bytes += this.viewPasses.overdraw.bytes + this.viewPasses.surfaceView.bytes;
    for (const passes of this.passLists.values()) for (const pass of passes) bytes += pass.bytes;
    for (const effect of this.effects) bytes += effect.bytes;
    return bytes;
  }
}
