import type { FarolEffect, FarolRenderer, TechniqueName } from '@farol/renderer';
import { type Camera, NoToneMapping, type Scene as ThreeScene, Vector4, type WebGLRenderTarget } from 'three';
import { followEffects } from './followEffects';
import { LateCode } from '../base/LateCode';
import { needsPackage } from '../base/needsPackage';
import type { CameraComponent } from '../core/CameraComponent';
import type { Scene } from '../core/Scene';
import type { PictureChain } from './chain/PictureChain';
import { LastPicture } from './LastPicture';
import { PictureEffects } from './PictureEffects';
import { PictureLook } from './PictureLook';
import { PictureShadows } from './PictureShadows';
import { techniqueAbilities } from './techniqueAbilities';

const late = new LateCode(() => needsPackage('postprocessing', "Effects of a scene's picture need", import('./chain')));

/** Time budget (ms) of a frame: 60 frames a second. */
const BUDGET = { frame: 16.7, min: 0.5 };

/** Whether touch is the device's primary input. */
const isTouchScreen = (): boolean => globalThis.matchMedia?.('(pointer: coarse)').matches ?? false;

const takesPicture = (effect: FarolEffect): boolean => effect.takesPicture === true;

/** Draws a three scene: a FarolRenderer, or an object that draws with several of them side by side. */
export interface ScenePainter {
  render(scene: ThreeScene, camera: Camera): void;
}

/** Options of the constructor of PictureRenderer. */
export interface PictureRendererOptions {
  /** Requests a frame, for hosts that draw on demand. */
  readonly redraw?: () => void;
  /** Called when a technique, effect or asset of the scene cannot be drawn; the console is warned when absent. */
  readonly failed?: (error: unknown) => void;
  /**
   * Whether the scene's technique, anti-aliasing, ambient occlusion and the like are applied. Default true; false
   * leaves them to the host, as for thumbnails of the same scene.
   */
  readonly followsRendering?: boolean;
}

/**
 * Draws scenes with the picture settings: technique and effects of the renderer, tone mapping, bloom, depth of field,
 * grading. Without post-processing a frame equals `FarolRenderer.render` in picture and cost; its code is fetched for
 * the first scene that uses it.
 */
export class PictureRenderer {
  readonly effects: PictureEffects;
  /** Whether bloom, depth of field, grading and vignette are drawn. Default true. */
  showsEffects = true;
  /** Whether a headset shows the pictures; set while a session lasts. */
  inXR = false;
  private readonly redraw: () => void;
  private readonly failed: (error: unknown) => void;
  private readonly followsRendering: boolean;
  private readonly look = new PictureLook();
  private readonly shadows: PictureShadows;
  private readonly viewport = new Vector4();
  private tones = 0;
  private technique = 'auto';
  private quality: Scene['settings']['quality'] = 'auto';
  private frameBudget = 'off';
  private isFetching = false;
  private toldXR = false;
  private chain: PictureChain | null = null;
  private waitsFor: Promise<void> | null = null;
  private readonly last: LastPicture;

  constructor(
    readonly farol: FarolRenderer,
    options: PictureRendererOptions = {},
  ) {
    this.last = new LastPicture(options.redraw ?? (() => {}));
    this.redraw = this.last.redraw;
    farol.addEventListener('redraw', this.redraw);
    this.failed = options.failed ?? ((error) => console.error((error as Error).message));
    this.followsRendering = options.followsRendering ?? true;
    this.effects = new PictureEffects(farol, this.redraw, this.failed);
    this.shadows = new PictureShadows(farol);
  }

  /**
   * Draws to the render target, viewport and scissor of the WebGLRenderer.
   * @param camera - camera to draw with
   * @param component - component of the camera, whose settings override the scene's; null for a camera of the host's
   */
  render(scene: Scene, camera: Camera, component: CameraComponent | null = null): void {
    this.follow(scene);
    this.draw(scene, camera, component);
    if (this.followsRendering) this.effects.update(scene.settings);
  }

  /**
   * Draws like `render`, for hosts that draw several views of a scene per frame: call `follow` before the first view
   * and `effects.update` after the last.
   */
  draw(scene: Scene, camera: Camera, component: CameraComponent | null): void {
    const { farol, look } = this;
    this.last.begin(scene);
    look.follow(scene.settings, component);
    const chain = farol.view === 'final' ? this.chainFor(scene) : null;
    this.noticeTones(chain);
    if (chain === null) this.renderPlain(farol, scene, camera);
    else this.renderByChain(chain, scene, camera);
    this.last.end();
  }

  /** Draws like `draw`, but with another painter, with the scene's tone mapping and without effects. */
  drawBy(painter: ScenePainter, scene: Scene, camera: Camera, component: CameraComponent | null): void {
    this.look.follow(scene.settings, component);
    this.renderPlain(painter, scene, camera);
  }

  /** Applies the scene's technique again in the next frame, as a plugin may have registered it after the last frame. */
  retakeTechnique(): void {
    if (this.technique !== 'auto') this.technique = '';
  }

  dispose(): void {
    this.farol.removeEventListener('redraw', this.redraw);
    this.free();
    this.effects.dispose();
    this.last.dispose();
  }

  /**
   * Resolves when the last drawn scene's picture is final as long as nothing moves: assets are loaded or have failed,
   * code is fetched, the renderer is ready (`FarolRenderer.ready`), and accumulating effects have all their frames. It
   * requests frames by `redraw`, at least one, and waits while there is no scene.
   *
   * Rejects when code cannot be fetched, with an Error that says what to do, and when this renderer is disposed.
   */
  get ready(): Promise<void> {
    return import('./whenDrawn').then(({ whenDrawn }) =>
      whenDrawn({ last: this.last, farol: this.farol, effects: this.effects }),
    );
  }

  /**
   * Whether the last frame had all assets, code and programs that `ready` waits for; accumulating effects may still
   * lack frames.
   */
  get isComplete(): boolean {
    const { scene, isStale } = this.last;
    const isRead = scene?.assets.isSettled === true && LateCode.fetching.size === 0;
    return isRead && !isStale && this.farol.info.pending.length === 0;
  }

  /** Updates the renderer for a scene: technique, effects, shadows, sky. */
  follow(scene: Scene): void {
    const { farol } = this;
    const { settings } = scene;
    followEffects(farol, scene, this.redraw);
    const { skyReady } = settings;
    if (skyReady !== this.waitsFor) {
      this.waitsFor = skyReady;
      skyReady?.then(this.redraw, this.failed);
    }
    if (!this.followsRendering) return;
    if (settings.technique !== this.technique) this.setTechnique(settings.technique);
    if (settings.quality !== this.quality) farol.quality = this.quality = settings.quality;
    if (settings.frameBudget !== this.frameBudget) {
      this.frameBudget = settings.frameBudget;
      const on = this.frameBudget === 'on' || (this.frameBudget === 'auto' && isTouchScreen());
      farol.budget = on ? BUDGET : null;
    }
    this.shadows.follow(settings);
    this.effects.update(settings);
    this.effects.setTime(scene.time);
  }

  /**
   * Sets the renderer's technique; one that is unknown, or that the device cannot run, is reported and replaced by
   * 'auto'.
   */
  private setTechnique(technique: string): void {
    const { farol } = this;
    this.technique = technique;
    try {
      farol.technique = technique as TechniqueName;
    } catch (error) {
      farol.technique = 'auto';
      this.failed(error);
    }
  }

  /** Resets effects that accumulate frames when tone mapping changes: older frames hold other values. */
  private noticeTones(chain: PictureChain | null): void {
    const { toneMapping, exposure } = this.look;
    const tones = chain !== null ? -1 : toneMapping === NoToneMapping ? 0 : toneMapping + exposure / 1e4;
    if (tones === this.tones) return;
    this.tones = tones;
    this.effects.forgetFrames();
  }

  private renderPlain(painter: ScenePainter, scene: Scene, camera: Camera): void {
    const { webgl } = this.farol;
    const { toneMapping, exposure } = this.look;
    if (toneMapping === NoToneMapping) {
      painter.render(scene.three, camera);
      return;
    }
    const before = webgl.toneMapping;
    const exposureBefore = webgl.toneMappingExposure;
    webgl.toneMapping = toneMapping;
    webgl.toneMappingExposure = exposure;
    const code = webgl.getRenderTarget() === null || this.inXR ? this.ask() : null;
    code?.surroundings.toneMap(scene.three, toneMapping, exposure);
    try {
      painter.render(scene.three, camera);
    } finally {
      webgl.toneMapping = before;
      webgl.toneMappingExposure = exposureBefore;
      code?.surroundings.restore(scene.three);
    }
  }

  private renderByChain(chain: PictureChain, scene: Scene, camera: Camera): void {
    const { farol, look, viewport } = this;
    const { webgl } = farol;
    const target = webgl.getRenderTarget() as WebGLRenderTarget | null;
    const { autoClear } = webgl;
    webgl.getCurrentViewport(viewport);
    const own = chain.begin(viewport.z, viewport.w, this.samples);
    const face = webgl.getActiveCubeFace();
    const level = webgl.getActiveMipmapLevel();
    try {
      webgl.setRenderTarget(own);
      webgl.autoClear = true;
      farol.render(scene.three, camera);
    } finally {
      webgl.autoClear = autoClear;
      webgl.setRenderTarget(target, face, level);
    }
    chain.draw(scene, look, camera, target);
  }

  /** Samples per pixel: as the canvas, unless a G-buffer or an anti-aliasing effect makes them useless. */
  private get samples(): number {
    const { webgl, info, techniques, effects } = this.farol;
    if (webgl.getContextAttributes()?.antialias !== true || effects.some(takesPicture)) return 0;
    return techniqueAbilities(techniques, info.technique).samples ? 4 : 0;
  }

  /** Effect chain of the scene; null without effects, or until their late code is loaded. */
  private chainFor({ settings }: Scene): PictureChain | null {
    const { look } = this;
    const { bloom, grading, vignette } = settings;
    const has = this.showsEffects && (bloom || grading || vignette || look.depthOfField);
    // XR views are drawn directly to the session's layer
    if (this.inXR) {
      if (has && !this.toldXR) console.warn('Farol: bloom, grading, vignette and depth of field are not drawn in XR.');
      this.toldXR ||= Boolean(has);
      return null;
    }
    // three applies tone mapping only when it draws to the canvas
    const isApart = this.farol.webgl.getRenderTarget() !== null && look.toneMapping !== NoToneMapping;
    if (!has && !isApart && look.automatic === null) return null;
    const code = this.ask();
    if (code === null || !code.PictureChain.isPossible(this.farol.webgl)) return null;
    this.chain ??= this.makeChain(code);
    this.chain.showsEffects = this.showsEffects;
    return this.chain;
  }

  /** Requests the code of tone mapping and effects; null until it is fetched. */
  private ask(): typeof late.code {
    if (late.code !== null || this.isFetching) return late.code;
    this.isFetching = true;
    late.load().then(() => this.last.isDisposed || this.redraw(), this.failed);
    return null;
  }

  private makeChain({ PictureChain }: NonNullable<typeof late.code>): PictureChain {
    const { webgl } = this.farol;
    // the chain must be freed before the context is restored: three would else delete its textures in the new context
    webgl.domElement.addEventListener('webglcontextlost', this.free);
    return new PictureChain(webgl, this.redraw);
  }

  private readonly free = (): void => {
    if (this.chain === null) return;
    this.farol.webgl.domElement.removeEventListener('webglcontextlost', this.free);
    this.chain.dispose();
    this.chain = null;
  };
}
