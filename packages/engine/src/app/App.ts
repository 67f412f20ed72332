import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import type { WebGLRenderer, WebGLRendererParameters } from 'three';
import type { EngineKeyEvent, EnginePointerEvent } from '../core/events';
import { builtinComponents } from '../components/index';
import { Scene } from '../core/Scene';
import { createWebGLRenderer } from './createWebGLRenderer';
import { PictureRenderer } from '../picture/PictureRenderer';
import { InputRouter } from './InputRouter';
import { MicroShaderOverrides } from './MicroShaderOverrides';

/** Options of the constructor of App. */
export interface AppOptions {
  /** Canvas to draw to; one is made when absent. */
  canvas?: HTMLCanvasElement;
  /** Element that the canvas is appended to, and whose size the canvas follows until `resize` is called. */
  parent?: HTMLElement;
  /** Parameters of three's WebGLRenderer, such as `antialias`. */
  renderer?: WebGLRendererParameters;
  /** A WebGLRenderer of the host's, in place of a new one; `canvas`, `parent` and `renderer` are then ignored. */
  webgl?: WebGLRenderer;
  /** Key of the renderer's `techniques`; its default when absent. */
  technique?: TechniqueName;
  /** Scene to show; an empty one when absent. */
  scene?: Scene;
  /** Target of key listeners; the window when absent, null for no keys. */
  keys?: EventTarget | null;
  /** Longest step of simulation in seconds, however long a frame took; 0.1 when absent. */
  maxDelta?: number;
}

/** Argument of `onFrame` listeners after each frame; one object is reused. */
export interface FrameInfo {
  /** Seconds by which the simulation advanced; 0 while it is paused. */
  readonly deltaSeconds: number;
  /** The scene's time in seconds. */
  readonly time: number;
}

/**
 * Canvas, loop and input of a scene (thesis 3.2.1). Each frame updates the scene and draws it with its active camera;
 * pointer and key events go to the scene, which passes them on to its components.
 */
export class App {
  readonly canvas: HTMLCanvasElement;
  /** three's renderer of the app's canvas. */
  readonly webgl: WebGLRenderer;
  /** Farol's renderer, which draws the scene. */
  readonly renderer: FarolRenderer;
  /** Draws with `renderer`, and applies the picture settings of the scene. */
  readonly picture: PictureRenderer;

  private readonly input: InputRouter;
  private readonly listeners = new Set<(frame: FrameInfo) => void>();
  private readonly ownsWebgl: boolean;
  private readonly ownsCanvas: boolean;
  private readonly maxDelta: number;
  private readonly overrides: MicroShaderOverrides;
  private unwatch: () => void = () => {};
  private sizes: ResizeObserver | null = null;
  private currentScene: Scene;
  private request = 0;
  private lastFrame = 0;
  private isPlaying = true;
  private isDisposed = false;
  private readonly info = { deltaSeconds: 0, time: 0 };
  private aspectWidth = 1;
  private aspectHeight = 1;

  /** @throws Error when the browser has no WebGL 2, or the technique is unknown */
  constructor(options: AppOptions = {}) {
    this.ownsWebgl = !options.webgl;
    this.ownsCanvas = !options.webgl && !options.canvas;
    const { canvas } = options;
    this.webgl = options.webgl ?? createWebGLRenderer({ ...options.renderer, ...(canvas ? { canvas } : {}) });
    this.canvas = this.webgl.domElement;
    if (!options.webgl) this.webgl.shadowMap.enabled = true;
    this.renderer = new FarolRenderer(this.webgl, options.technique ? { technique: options.technique } : {});
    this.picture = new PictureRenderer(this.renderer, { redraw: () => this.redrawAtRest() });
    this.currentScene = options.scene ?? new Scene({ registry: builtinComponents });
    this.maxDelta = options.maxDelta ?? 0.1;
    this.overrides = new MicroShaderOverrides(this.renderer.microshaders);
    this.watchMicroShaders();
    if (options.parent && !options.webgl) {
      if (this.ownsCanvas) Object.assign(this.canvas.style, { display: 'block', touchAction: 'none' });
      options.parent.append(this.canvas);
      this.follow(options.parent);
    }
    const keys = options.keys === undefined ? globalThis.window : options.keys;
    this.input = new InputRouter(this.canvas, keys ?? null, {
      dispatchPointer: (event: EnginePointerEvent) => this.currentScene.dispatchPointer(event),
      dispatchKey: (event: EngineKeyEvent) => this.currentScene.dispatchKey(event),
    });
  }

  /** The scene that is drawn. Setting another does not dispose of the old one, which may be set again. */
  get scene(): Scene {
    return this.currentScene;
  }

  set scene(scene: Scene) {
    if (scene === this.currentScene) return;
    this.input.releaseKeys();
    this.currentScene = scene;
    this.watchMicroShaders();
  }

  /** Whether the frame loop runs. */
  get running(): boolean {
    return this.request !== 0;
  }

  /** Whether frames of the loop advance the simulation. */
  get playing(): boolean {
    return this.isPlaying;
  }

  /** Starts the loop: each display frame updates the scene and draws it. While an XR session presents, the session draws. */
  start(): void {
    if (this.running || this.isDisposed || this.picture.inXR) return;
    this.lastFrame = 0;
    this.request = requestAnimationFrame(this.frame);
  }

  /** Ends the frame loop; the last picture stays on the canvas. */
  stop(): void {
    cancelAnimationFrame(this.request);
    this.request = 0;
    this.currentScene.pause();
  }

  /** Starts or resumes the simulation. */
  play(): void {
    this.isPlaying = true;
  }

  /** Pauses the simulation; the loop continues drawing. */
  pause(): void {
    this.isPlaying = false;
    this.currentScene.pause();
  }

  /** Advances the simulation by `deltaSeconds`, playing or not, and draws. */
  step(deltaSeconds = 1 / 60): void {
    this.advance(deltaSeconds);
  }

  /** Moves the scene to a time (s), with the same result in every run, and draws exactly one frame. */
  renderAt(seconds: number): void {
    this.currentScene.setTime(seconds);
    this.render();
    this.tell(0);
  }

  /**
   * Resolves when the picture is final as long as nothing moves: assets and code are loaded, and a frame was drawn with
   * them; see `PictureRenderer.ready`. While the loop is stopped, the getter draws the frames itself. Waits while the
   * scene has no camera.
   *
   * Rejects when code cannot be fetched, with an Error that says what to do, and when the app is disposed.
   */
  get ready(): Promise<void> {
    return this.picture.ready;
  }

  /** Draws the scene without updating it; only the background when it has no camera. */
  render(): void {
    const camera = this.currentScene.activeCamera;
    if (!camera) {
      this.webgl.clear();
      return;
    }
    camera.setViewport(this.aspectWidth, this.aspectHeight);
    this.picture.render(this.currentScene, camera.three, camera);
  }

  /**
   * Sets the size of the canvas, which no longer follows its parent.
   * @param width - CSS pixels, at least 1
   * @param height - CSS pixels, at least 1
   * @param pixelRatio - device pixels per CSS pixel; unchanged when absent
   */
  resize(width: number, height: number, pixelRatio?: number): void {
    this.sizes?.disconnect();
    this.setSize(width, height, pixelRatio);
  }

  /** Keeps the canvas as large as an element. */
  private follow(parent: HTMLElement): void {
    const fit = (): void => {
      if (this.picture.inXR) return; // an XR session sizes the canvas itself
      const width = Math.max(1, parent.clientWidth);
      const height = Math.max(1, parent.clientHeight);
      if (width === this.aspectWidth && height === this.aspectHeight) return;
      this.setSize(width, height);
      // resizing empties the canvas: it is drawn again before the browser shows it
      this.render();
    };
    this.setSize(parent.clientWidth, parent.clientHeight);
    // ResizeObserver is absent in environments without layout
    if (typeof ResizeObserver === 'undefined') return;
    this.sizes = new ResizeObserver(fit);
    this.sizes.observe(parent);
  }

  private setSize(width: number, height: number, pixelRatio?: number): void {
    if (this.picture.inXR) return;
    this.aspectWidth = Math.max(1, width);
    this.aspectHeight = Math.max(1, height);
    if (pixelRatio !== undefined) this.webgl.setPixelRatio(pixelRatio);
    this.webgl.setSize(this.aspectWidth, this.aspectHeight);
  }

  /** Calls `listener` after each frame that is drawn. @returns a function that removes the listener */
  onFrame(listener: (frame: FrameInfo) => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  /** Ends loop and input and frees the renderers. The scene stays, as do a canvas or a WebGLRenderer of the host's. */
  dispose(): void {
    this.isDisposed = true;
    this.sizes?.disconnect();
    this.stop();
    if (this.picture.inXR) void this.webgl.xr.getSession()?.end();
    this.input.dispose();
    this.listeners.clear();
    this.unwatch();
    this.picture.dispose();
    this.renderer.dispose();
    if (this.ownsWebgl) this.webgl.dispose();
    if (this.ownsCanvas) this.canvas.remove();
  }

  /** Applies the scene's microshaders, now and on changes. A text that does not compile is reported and ignored. */
  private watchMicroShaders(): void {
    const { currentScene: scene } = this;
    const apply = (): void => {
      for (const { error } of this.overrides.apply(scene.microShaders.texts)) console.error(error.message);
    };
    this.unwatch();
    this.unwatch = scene.onChange(({ kind }) => kind === 'microshader' && apply());
    apply();
  }

  private readonly redrawAtRest = (): void => {
    if (!this.running && !this.isDisposed && !this.picture.inXR) this.render();
  };

  private readonly frame = (now: number): void => {
    this.request = requestAnimationFrame(this.frame);
    const elapsed = this.lastFrame === 0 ? 0 : (now - this.lastFrame) / 1000;
    this.lastFrame = now;
    if (this.isPlaying) this.advance(Math.min(Math.max(elapsed, 0), this.maxDelta));
    else this.advance(null);
  };

  /** Updates the scene (unless `deltaSeconds` is null), draws it and calls the frame listeners. */
  private advance(deltaSeconds: number | null): void {
    if (deltaSeconds !== null) this.currentScene.update(deltaSeconds);
    this.render();
    this.tell(deltaSeconds ?? 0);
  }

  private tell(deltaSeconds: number): void {
    this.info.deltaSeconds = deltaSeconds;
    this.info.time = this.currentScene.time;
    for (const listener of this.listeners) listener(this.info);
  }
}
