import type { Camera, Material, Mesh, Object3D, WebGLRenderer } from 'three';
import { drawOnePixel } from '../../renderer/warm-up/compileByDrawing';
import { type FarolOptions, setOptions } from '../../renderer/FarolOptions';
import { FarolRenderer } from '../../renderer/FarolRenderer';
import { type Interception, interceptRender } from '../intercept';
import { isWorthFarol } from './isWorthFarol';

/** Settings of one `<Farol>` component of a canvas. */
export interface FarolSettings {
  readonly options: FarolOptions;
  /** Scene that the settings apply to; null for every scene that the canvas draws. */
  readonly scene: Object3D | null;
  /** Makes react-three-fiber render a frame. */
  readonly invalidate: () => void;
}

const canvases = new WeakMap<WebGLRenderer, CanvasFarol>();

/**
 * The one FarolRenderer of a canvas, kept while a component is mounted. Replaces `render`, `compile` and `compileAsync` of the
 * WebGLRenderer, so that Farol draws whatever R3F or a component draws by these.
 */
export class CanvasFarol {
  farol: FarolRenderer | null = null;
  private readonly mounted = new Map<object, FarolSettings>();
  private readonly listeners = new Set<() => void>();
  private released: FarolSettings[] = [];
  private applied: FarolSettings | null = null;
  private interception: Interception | null = null;
  private unhookCompile: (() => void) | null = null;

  static of(webgl: WebGLRenderer): CanvasFarol {
    let canvas = canvases.get(webgl);
    if (canvas === undefined) canvases.set(webgl, (canvas = new CanvasFarol(webgl)));
    return canvas;
  }

  private constructor(private readonly webgl: WebGLRenderer) {}

  /** Adds a listener to changes of `farol`. @returns function that removes it */
  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };

  readonly current = (): FarolRenderer | null => this.farol;

  /**
   * Applies a component's settings from the next draw on.
   * @param owner - identifies the component
   * @throws Error as FarolRenderer and `setOptions` do
   */
  mount(owner: object, settings: FarolSettings): void {
    if (this.mounted.get(owner) === settings && this.farol !== null) return;
    this.mounted.set(owner, settings);
    try {
      if (this.farol === null) this.make();
      this.apply(settings);
    } catch (error) {
      this.unmount(owner);
      throw error;
    }
    if (this.interception === null) this.hook();
    settings.invalidate();
  }

  /** Removes a component's settings; after the last one's, disposes the renderer, unless a component mounts at once. */
  unmount(owner: object): void {
    const settings = this.mounted.get(owner);
    if (settings === undefined) return;
    this.mounted.delete(owner);
    this.applied = null;
    if (this.mounted.size === 0) this.unhook();
    this.released.push(settings);
    if (this.released.length === 1) queueMicrotask(() => this.settle());
    settings.invalidate();
  }

  private make(): void {
    this.farol = new FarolRenderer(this.webgl);
    this.farol.addEventListener('redraw', () => this.applied?.invalidate());
    this.tell();
  }

  /**
   * Disposes effects and FarolRenderer that no component uses any more. Deferred, since StrictMode and hot reload unmount and
   * mount at once.
   */
  private settle(): void {
    const { farol, released, mounted } = this;
    this.released = [];
    const kept = new Set([...mounted.values()].flatMap(({ options }) => options.effects ?? []));
    for (const { options } of released)
      for (const effect of options.effects ?? []) if (!kept.has(effect)) effect.dispose();
    if (mounted.size > 0 || farol === null) return;
    this.farol = null;
    farol.dispose();
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }

  private apply(settings: FarolSettings): void {
    if (this.applied === settings) return;
    const { options } = settings;
    // all scenes of the canvas share one atlas
    const [{ options: first }] = this.mounted.values();
    setOptions(this.farol!, { ...options, shadowAtlasSize: first.shadowAtlasSize });
    this.applied = settings;
  }

  /** Settings for a scene that Farol draws; null if three draws it. */
  private settingsFor(scene: Object3D, camera: Camera): FarolSettings | null {
    let found: FarolSettings | null = null;
    if (this.farol === null) return null;
    for (const settings of this.mounted.values()) {
      if (settings.scene === scene) {
        found = settings;
        break;
      }
      if (settings.scene === null) found ??= settings;
    }
    return found !== null && isWorthFarol(scene, camera, (found.options.effects?.length ?? 0) > 0) ? found : null;
  }

  private hook(): void {
    const { webgl } = this;
    this.interception = interceptRender(webgl, (scene, camera, next) => {
      const settings = this.settingsFor(scene, camera);
      if (settings === null) return next(scene, camera);
      this.apply(settings);
      this.farol!.render(scene, camera);
    });
    const { compile, compileAsync } = webgl;
    const prepare = (scene: Object3D, camera: Camera, target: Object3D | null): boolean => {
      // Farol compiles programs by drawing; in an XR session only the session's frames do so
      const isOwn = (target === null || target === scene) && !webgl.xr.isPresenting;
      const settings = isOwn ? this.settingsFor(scene, camera) : null;
      if (settings !== null) this.apply(settings);
      return settings !== null;
    };
    const ownCompile: typeof compile = (scene, camera, target = null) => {
      if (!prepare(scene, camera, target)) return compile.call(webgl, scene, camera, target);
      drawOnePixel(this.farol!, scene, camera);
      return materialsOf(scene);
    };
    const ownCompileAsync: typeof compileAsync = async (scene, camera, target = null) => {
      if (!prepare(scene, camera, target)) return compileAsync.call(webgl, scene, camera, target);
      await this.farol!.compileAsync(scene, camera);
      return scene;
    };
    Object.assign(webgl, { compile: ownCompile, compileAsync: ownCompileAsync });
    this.unhookCompile = () => {
      if (webgl.compile === ownCompile) webgl.compile = compile;
      if (webgl.compileAsync === ownCompileAsync) webgl.compileAsync = compileAsync;
    };
  }

  private unhook(): void {
    this.interception?.remove();
    this.interception = null;
    this.unhookCompile?.();
    this.unhookCompile = null;
  }
}

function materialsOf(scene: Object3D): Set<Material> {
  const materials = new Set<Material>();
  scene.traverse((object) => {
    const { material } = object as Partial<Mesh>;
    for (const one of [material ?? []].flat()) materials.add(one);
  });
  return materials;
}
