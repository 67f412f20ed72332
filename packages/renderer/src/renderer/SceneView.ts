import {
  BufferGeometry,
  type Camera,
  DoubleSide,
  type Light,
  Material,
  Mesh,
  Object3D,
  type Scene,
  type WebGLRenderer,
} from 'three';
import type { Overdraw } from './warm-up/Overdraw';
import type { WarmUp } from './warm-up/WarmUp';
import { type RenderList, type RenderLists, renderListsOf } from '../three/RenderList';
import type { RenderQueue } from '../frame/RenderQueue';
import type { Fills } from '../frame/Fills';
import type { ShadowMapCalls } from '../shadows/draw/ShadowMapCalls';
import { standInOf } from '../three/standInOf';
import type { TechniqueName } from '../techniques';
import type { TechniqueChooser } from './warm-up/TechniqueChooser';
import type { ArrayTraversal } from './camera-arrays/ArrayTraversal';
import { arrayCode } from './drawCameras';

/** Draws shadow maps inside three's `render`, with proxies of casters outside the camera's view. */
export interface ShadowDraws {
  readonly proxies: readonly Object3D[];
  readonly calls: ShadowMapCalls;
}

/** @param backs - true to draw only back faces of double-sided transmissive objects, into three's transmission target */
export type DrawScene = (backs: boolean) => void;

/** Stand-in for a host's scene that three's `render` is given. */
export type FarolView = Object3D & { readonly isFarolView?: true };

const NOTHING = () => undefined;
const CLEARS = ['autoClear', 'autoClearColor', 'autoClearDepth', 'autoClearStencil'] as const;
const NEVER = [false, false, false, false];

/**
 * Stand-in for a host's scene that three's own `render` is given: three does traversal, culling, geometry updates,
 * background and shadow maps, but neither draws the scene's objects nor sees managed lights. The host's scene is only
 * read. `draw` is called back inside `render`, where `renderBufferDirect` works.
 */
export class SceneView {
  /** Picks the scene's technique for 'auto'; null until 'auto' is used and its code is loaded. */
  chooser: TechniqueChooser<WarmUp> | null = null;
  /** Technique that drew the scene's last frame; null before the first frame. */
  drawn: TechniqueName | null = null;
  /** Estimate of the scene's overdraw; null until its code is loaded. */
  overdraw: Overdraw | null = null;
  private readonly view: Object3D & { overrideMaterial?: Material | null };
  private readonly children: Object3D[] = [];
  private lights: readonly Light[] = [];
  private readonly masks: number[] = [];
  private readonly driver: Mesh;
  private list!: RenderList;
  /** three's render lists, among them `list`; replaced when a lost context is restored. */
  private lists!: RenderLists;
  private getList!: RenderLists['get'];
  /** Whether the host's code has thrown in this frame; `error` is rethrown after three's `render`, which restores its stacks. */
  private failed = false;
  private error: unknown;
  /** Stands for all transmissive objects in three's list: three fills its transmission target only if the list has one. */
  private readonly glass: Mesh;
  private transmits = false;
  /** Array of cameras that contains the camera, or the camera itself: drawn objects must share a layer with it too. */
  seenBy!: Camera;
  /** Traversal for a camera of an array; null until there was one. */
  private array: ArrayTraversal | null = null;
  private camera!: Camera;
  /** Whether three is kept from updating the camera's matrices, which are up to date, a second time. */
  private holdsCamera = false;
  private queue: RenderQueue | null = null;
  private fills: Fills | null = null;
  /** The host's values of the four `CLEARS` flags, while three is kept from clearing. */
  private readonly autoClear = [true, true, true, true];
  private keeps = false;
  /** Pixels that draws must write, since three was kept from clearing the target; null if three clears. */
  uncleared: Fills | null = null;
  private draw: DrawScene | null = null;

  constructor(
    private readonly webgl: WebGLRenderer,
    private readonly source: Object3D,
    /** Called inside `render` when three's render lists are complete and nothing is drawn yet. */
    private readonly begun: () => void,
  ) {
    const scene = source as Scene;
    if (scene.isScene === true) {
      this.view = standInOf(scene, Object3D.prototype);
      // called by FarolRenderer, before lights are collected
      this.define('onBeforeRender', this.freeCamera);
      this.define('onAfterRender', NOTHING);
    } else {
      this.view = new Object3D();
    }
    this.define('children', this.children);
    this.define('matrixWorldAutoUpdate', false);
    this.define('isFarolView', true);
    this.driver = makeDriver(() => {
      this.restoreClear();
      this.drawAll(false);
    });
    this.glass = makeDriver(() => this.drawAll(true));
    // as a transmissive, double-sided item it makes three draw the back faces of the transmission pass
    Object.assign(this.glass.material, { transmission: 1, side: DoubleSide });
    this.takeList();
  }

  /**
   * Runs three's `render`.
   * @param lights - lights below the root that are hidden from three's traversal
   * @param rest - children of the root for three's traversal, without managed lights, see `FoundLights`
   * @param queue - gets the items in three's order
   * @param draw - draws the scene; also called for three's transmission target if an object transmits
   * @param fills - pixels that draws write, so that three need not clear them
   * @param shadows - maps to draw when three draws its own
   * @param isUpdated - whether the camera's matrices are up to date
   */
  render(
    camera: Camera,
    lights: readonly Light[],
    rest: readonly Object3D[],
    queue: RenderQueue,
    draw: DrawScene,
    fills: Fills | null,
    shadows: ShadowDraws | null,
    isUpdated: boolean,
  ): void {
    if (this.lists !== renderListsOf(this.webgl)) this.takeList();
    this.queue = queue;
    this.draw = draw;
    this.fills = fills;
    queue.clear();
    this.children.length = 0;
    for (const child of rest) this.children.push(child);
    if (shadows !== null) for (const proxy of shadows.proxies) this.children.push(proxy);
    this.lights = lights;
    this.camera = camera;
    this.failed = false;
    shadows?.calls.begin(this.view, this.fail);
    this.getList = this.lists.get;
    this.lists.get = this.giveList;
    // three calls `freeCamera`, a Scene's `onBeforeRender`, after the point where it would update the camera's matrices
    this.holdsCamera = isUpdated && camera.matrixWorldAutoUpdate && (this.source as Scene).isScene === true;
    if (this.holdsCamera) camera.matrixWorldAutoUpdate = false;
    try {
      this.webgl.render(this.view as Object3D, camera);
    } finally {
      this.lists.get = this.getList;
      this.freeCamera();
      shadows?.calls.end();
      this.restore();
      this.restoreClear();
      this.queue = this.draw = null;
    }
    if (!this.failed) return;
    const { error } = this;
    this.error = undefined;
    throw error;
  }

  /**
   * Ends the frame's drawing after the host's code has thrown. The exception reaches the host when three's `render` is done:
   * three's stacks of lists and lights, its target and its clipping are always restored.
   */
  private readonly fail = (error: unknown): void => {
    if (!this.failed) this.error = error;
    this.failed = true;
  };

  private readonly freeCamera = (): void => {
    if (this.holdsCamera) this.camera.matrixWorldAutoUpdate = true;
    this.holdsCamera = false;
  };

  /** Empties three's list of transmissive items, which Farol draws. */
  dropTransmissive(): void {
    this.list.transmissive.length = 0;
  }

  private define(name: string, value: unknown): void {
    Object.defineProperty(this.view, name, { value, writable: true, configurable: true });
  }

  /** Hides the lights as three's traversal begins; the scene's `onBeforeRender` has run. */
  private hide(): void {
    if ('isArrayCamera' in this.seenBy) this.array ??= new arrayCode.required.ArrayTraversal();
    this.array?.begin(this.camera, this.seenBy);
    for (const { layers } of this.lights) {
      this.masks.push(layers.mask);
      layers.mask = 0;
    }
  }

  /** Restores the layers of the lights; three's traversal ends before any callback of the host runs. */
  private restore(): void {
    this.array?.end();
    for (let i = 0; i < this.masks.length; i++) this.lights[i].layers.mask = this.masks[i];
    this.masks.length = 0;
  }

  /** Keeps three from clearing pixels that draws will fill; three still sets its clear colour. */
  private keepFromClearing(): void {
    const { webgl, autoClear, queue } = this;
    const fills = queue?.transmissive.length === 0 && !queue.ordered && this.clearsPlainly() ? this.fills : null;
    this.uncleared = fills === 'behind' && (!queue!.covers || queue!.reachesFar) ? null : fills;
    if (this.uncleared === null) return;
    for (let i = 0; i < 4; i++) autoClear[i] = webgl[CLEARS[i]];
    if (fills === 'behind') webgl.autoClearColor = false;
    else this.setAutoClear(NEVER);
    this.keeps = true;
  }

  private restoreClear(): void {
    if (this.keeps) this.setAutoClear(this.autoClear);
    this.keeps = false;
  }

  private setAutoClear(flags: readonly boolean[]): void {
    for (let i = 0; i < 4; i++) this.webgl[CLEARS[i]] = flags[i];
  }

  /** True if three is about to clear colour and depth to a colour, and draws no background. */
  private clearsPlainly(): boolean {
    const { webgl, source } = this;
    const background = (source as Scene).isScene === true ? (source as Scene).background : null;
    if (!webgl.autoClearColor || !webgl.autoClearDepth) return false;
    return background === null ? webgl.autoClear : 'isColor' in background;
  }

  private drawAll(backs: boolean): void {
    if (this.failed) return;
    const { webgl } = this;
    const target = webgl.getRenderTarget();
    const face = webgl.getActiveCubeFace();
    const level = webgl.getActiveMipmapLevel();
    try {
      this.draw?.(backs);
    } catch (error) {
      this.fail(error);
      webgl.setRenderTarget(target, face, level);
    }
  }

  /** Reserves one of three's render lists for all frames, at any depth of nested renders. */
  private takeList(): void {
    this.lists = renderListsOf(this.webgl);
    const list = (this.list = this.lists.get(this.view, 0));
    const { init, push, finish } = list;
    const { driver } = this;
    list.push = (object, geometry, material, groupOrder, z, group, camera) => {
      if ((object as Object3D & { isFarolProxy?: boolean }).isFarolProxy === true) return;
      if (!object.layers.test(this.seenBy.layers)) return;
      const override = this.view.overrideMaterial ?? null;
      if (camera?.reversedDepth === true) z = -z;
      z = this.array?.depthOf(object, geometry, z) ?? z;
      this.queue?.push(object, geometry, material, groupOrder, z, group, override);
      if (this.transmits || !(((material as Material & { transmission?: number }).transmission ?? 0) > 0)) return;
      this.transmits = true;
      push(this.glass, this.glass.geometry, this.glass.material as Material, 0, 0, null, camera);
    };
    list.init = () => {
      this.transmits = false;
      this.hide();
      init();
    };
    list.finish = () => {
      this.restore();
      this.queue?.finish();
      this.begun();
      this.keepFromClearing();
      push(driver, driver.geometry, driver.material as Material, 0, 0, null, this.anyCamera);
      finish();
    };
    list.sort = (opaque, transparent, reversed = false) => {
      try {
        this.queue?.sort(opaque, transparent, reversed);
      } catch (error) {
        this.fail(error);
      }
    };
  }

  private readonly giveList: RenderLists['get'] = (scene, depth) =>
    scene === this.view ? this.list : this.getList(scene, depth);

  private readonly anyCamera = { reversedDepth: false } as unknown as Camera;
}

/** Makes an item without triangles; three reads its layers when it would draw it, and Farol draws at that moment. */
function makeDriver(draw: () => void): Mesh {
  const driver = new Mesh(new BufferGeometry(), new Material());
  driver.layers.test = () => {
    draw();
    return false;
  };
  return driver;
}
