import {
  type Camera,
  Color,
  DataUtils,
  HalfFloatType,
  type Light,
  type LineSegments,
  type Object3D,
  type Points,
  type Scene,
  type Texture,
  WebGLRenderTarget,
} from 'three';
import type { RenderItem } from '../frame/RenderItem';
import type { FarolRenderer } from '../renderer/FarolRenderer';
import type { TechniqueName } from '../techniques';
import { DrawnParts } from './DrawnParts';
import { windowCamera } from './windowCamera';

/** Side of the drawn window (pixels), a multiple of tile sizes, so that tiles and pixel quads align as in the picture. */
const WINDOW = 16;

type Line = LineSegments & { readonly material: { readonly isLineMaterial?: boolean } };

/** Whether an object's size or clipping depends on the target's size, as for points and thick lines: no window then. */
const goesByTarget = ({ object }: RenderItem): boolean =>
  (object as Points).isPoints === true || (object as Line).material.isLineMaterial === true;

/** Whether the host's own shader draws an item; it may read its position in the picture. */
const hasOwnShader = ({ ownShader }: RenderItem): boolean => ownShader;

/** One pixel of a picture, drawn with any lights of the scene; in a small window of the picture if that gives the same colour. */
export class PixelPicture {
  readonly parts: DrawnParts;
  /** Whether parts are drawn as whole pictures, since the pixel depends on other pixels. */
  isWhole = false;
  readonly camera: Camera;
  private readonly whole: WebGLRenderTarget;
  private readonly window = new WebGLRenderTarget(WINDOW, WINDOW, { type: HalfFloatType });
  private readonly halves = new Uint16Array(4);

  /**
   * @param column - pixel from the left edge
   * @param row - pixel from the lower edge
   */
  constructor(
    private readonly farol: FarolRenderer,
    private readonly scene: Object3D,
    private readonly host: Camera,
    private readonly technique: TechniqueName,
    readonly column: number,
    readonly row: number,
    { width, height }: { readonly width: number; readonly height: number },
  ) {
    this.parts = new DrawnParts(farol.webgl.getContext() as WebGL2RenderingContext, host, farol.effects);
    this.whole = new WebGLRenderTarget(width, height, { type: HalfFloatType });
    this.camera = windowCamera(host, column - (column % WINDOW), row - (row % WINDOW), WINDOW, width, height);
  }

  /** Items of the last draw: those at the pixel, or in its window. */
  get items(): readonly RenderItem[] {
    const { opaque, transmissive, transparent } = this.parts.frame!.queue;
    return [...opaque, ...transmissive, ...transparent];
  }

  /** Draws the whole picture, which updates lights and shadow maps. */
  drawWhole(): void {
    const { parts } = this;
    parts.eye = 0;
    parts.lights = null;
    parts.isUnshadowed = false;
    this.drawTo(this.whole, this.host);
    parts.eye = 1;
  }

  /**
   * Chooses whether a window shows the pixel as the picture does; if so, the window is drawn on return. Call right after
   * `drawWhole`.
   */
  chooseWindow(): void {
    const { parts, farol, technique } = this;
    const { queue } = parts.frame!;
    const background = (this.scene as Scene).background as (Texture & { isTexture?: boolean; mapping: number }) | null;
    this.isWhole =
      parts.readsAround ||
      queue.transmissive.length > 0 ||
      // coarse lighting is interpolated between texels, which are at other positions in a window
      (technique === 'inferred' && farol.inferredScale < 1) ||
      (background?.isTexture === true && background.mapping === 300) ||
      this.items.some(goesByTarget);
    if (this.isWhole) return;
    this.draw(null);
    this.isWhole = this.items.some(hasOwnShader);
  }

  /** Reads the pixel in the whole picture drawn last. */
  readWhole(to = new Color()): Color {
    return this.read(this.whole, this.column, this.row, to);
  }

  /**
   * Draws the pixel lit by some lights.
   * @param lights - null for all
   * @param isUnshadowed - whether shadows are left out
   */
  draw(lights: readonly Light[] | null, isUnshadowed = false, to = new Color()): Color {
    const { parts, isWhole, whole, window, column, row } = this;
    parts.lights = lights;
    parts.isUnshadowed = isUnshadowed;
    this.drawTo(isWhole ? whole : window, isWhole ? this.host : this.camera);
    parts.isUnshadowed = false;
    return isWhole ? this.readWhole(to) : this.read(window, column % WINDOW, row % WINDOW, to);
  }

  dispose(): void {
    this.whole.dispose();
    this.window.dispose();
  }

  private drawTo(target: WebGLRenderTarget, camera: Camera): void {
    const { farol, scene, technique } = this;
    const { webgl } = farol;
    const { autoClear, autoClearColor, autoClearDepth, autoClearStencil } = webgl;
    const before = webgl.getRenderTarget();
    const face = webgl.getActiveCubeFace();
    const level = webgl.getActiveMipmapLevel();
    const { technique: asked, view } = farol;
    try {
      Object.assign(webgl, { autoClear: true, autoClearColor: true, autoClearDepth: true, autoClearStencil: true });
      if (asked !== technique) farol.technique = technique;
      if (view !== 'final') farol.view = 'final';
      webgl.setRenderTarget(target);
      farol['session'] = this.parts;
      farol.render(scene, camera);
    } finally {
      farol['session'] = null;
      webgl.setRenderTarget(before, face, level);
      Object.assign(webgl, { autoClear, autoClearColor, autoClearDepth, autoClearStencil });
      if (asked !== technique) farol.technique = asked;
      if (view !== 'final') farol.view = view;
    }
  }

  private read(target: WebGLRenderTarget, x: number, y: number, to: Color): Color {
    const { halves, farol } = this;
    farol.webgl.readRenderTargetPixels(target, x, y, 1, 1, halves);
    const [r, g, b] = halves;
    to.r = DataUtils.fromHalfFloat(r);
    to.g = DataUtils.fromHalfFloat(g);
    to.b = DataUtils.fromHalfFloat(b);
    return to;
  }
}
