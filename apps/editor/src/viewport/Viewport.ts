import { Signal } from '@farol/editing';
import {
  Camera as CameraComponent,
  createWebGLRenderer,
  followEffects,
  type GameObject,
  InputRouter,
} from '@farol/engine';
import { FarolRenderer, type MicroShaderRegistry, type TechniqueName, type View } from '@farol/renderer';
import { type Box2, type Camera, type Material, Vector2, type WebGLRenderer } from 'three';
import type { EditorDocument } from '../model/EditorDocument';
import type { Registry } from '../model/Registry';
import { boundsOf } from './boundsOf';
import { BoxSelect } from './BoxSelect';
import { CameraPreview } from './CameraPreview';
import { EditorCamera } from './EditorCamera';
import { FrameStatistics } from './FrameStatistics';
import { Gizmo, type GizmoMode, type GizmoSpace } from './Gizmo';
import { Helpers } from './Helpers';
import { MaterialBall } from './MaterialBall';
import { hitPoint, pick } from './pick';
import { pickBox } from './pickBox';
import type { Painter } from './Painter';
import { PointerPicker } from './PointerPicker';
import { type AddedEffect, type EffectChoice, ViewportEffects } from './ViewportEffects';

/** Icons up to this much farther (m) than the mesh at the same point are picked before it. */
const ICON_REACH = 0.4;

const middle = new Vector2();

/**
 * The picture of the document: canvas, camera, gizmo, picking, loop. It draws when something changed, each frame while
 * the scene plays, and always when `continuous` is set. It knows nothing of React.
 */
export class Viewport {
  /** Takes what goes wrong while a frame is drawn. */
  onError: (error: unknown) => void = () => {};
  /** Brings the scene's microshaders into another renderer that draws the scene. */
  shareMicroShaders: (registry: MicroShaderRegistry) => void = () => {};
  /** Emits when one of the settings below changes. */
  readonly changed = new Signal();
  /** Emits after each frame that was drawn. */
  readonly drawn = new Signal();
  /** GPU times of the last frame have come, after it: they are in `farol.info`. */
  readonly timed = new Signal();
  /** Emits when the picture has another size. */
  readonly resized = new Signal();
  readonly statistics = new FrameStatistics();
  readonly webgl: WebGLRenderer;
  readonly farol: FarolRenderer;
  readonly editorCamera: EditorCamera;
  readonly gizmo: Gizmo;
  readonly helpers: Helpers;
  readonly picker: PointerPicker;
  readonly boxSelect: BoxSelect;

  private readonly effects: ViewportEffects;
  private readonly input: InputRouter;
  private preview: CameraPreview | null = null;
  private ball: MaterialBall | null = null;
  private hasStatistics = false;
  private assetChanges = 0;
  private readonly endings: (() => void)[] = [];
  private readonly resizer = new ResizeObserver(() => this.resize());
  private through: CameraComponent | null = null;
  private ownPainter: Painter | null = null;
  private always = false;
  private pending = 1;
  private request = 0;
  private last = 0;
  private width = 1;
  private height = 1;

  /** @throws Error when the browser has no WebGL 2 */
  constructor(
    readonly document: EditorDocument,
    readonly canvas: HTMLCanvasElement,
  ) {
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    canvas.setAttribute('aria-label', 'Picture of the scene: arrow keys turn it, plus and minus bring it nearer');
    this.webgl = createWebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.webgl.shadowMap.enabled = true;
    this.farol = new FarolRenderer(this.webgl, { timing: true });
    this.effects = new ViewportEffects(this.farol, this.redraw, (error) => this.onError(error));
    const dragged = (isDragging: boolean): void => {
      this.editorCamera.enabled = !isDragging && this.through === null;
    };
    // the handles hear of the pointer before the camera does, so that a handle is taken and the camera stays
    const loaded = (): void => this.editorCamera.listenLast();
    this.gizmo = new Gizmo(document, canvas, dragged, this.redraw, loaded);
    this.editorCamera = new EditorCamera(canvas);
    this.helpers = new Helpers(document);
    this.helpers.scene.add(this.gizmo.three);
    this.boxSelect = new BoxSelect(this);
    this.picker = new PointerPicker(this);
    this.input = new InputRouter(canvas, window, {
      dispatchPointer: (event) => this.sceneListens && document.scene.dispatchPointer(event),
      dispatchKey: (event) => this.sceneListens && document.scene.dispatchKey(event),
    });
    for (const signal of [document.edited, document.selection.changed, document.simulation.changed, this.changed]) {
      this.endings.push(signal.subscribe(this.redraw));
    }
    this.endings.push(
      document.assetsChanged.subscribe(() => {
        this.assetChanges++;
        this.invalidate();
      }),
      document.opened.subscribe(() => this.sceneOpened()),
    );
    this.endings.push(document.structure.subscribe(() => this.checkCamera()));
    canvas.addEventListener('webglcontextrestored', this.redraw);
    this.request = requestAnimationFrame(this.frame);
  }

  get technique(): TechniqueName {
    return this.farol.technique;
  }

  /** @throws Error naming what the device lacks */
  set technique(technique: TechniqueName) {
    this.farol.technique = technique;
    this.changed.emit();
  }

  get view(): View {
    return this.farol.view;
  }

  set view(view: View) {
    this.farol.view = view;
    this.changed.emit();
  }

  /** Lights, or draws, a pixel that the views of counts show hottest. */
  setHeatMapMaximum(maximum: number): void {
    this.farol.heatMapMaximum = maximum;
    this.changed.emit();
  }

  /** What draws the picture in place of `farol` alone; null for nothing. It is disposed when another one comes. */
  get painter(): Painter | null {
    return this.ownPainter;
  }

  set painter(painter: Painter | null) {
    if (painter === this.ownPainter) return;
    this.ownPainter?.dispose();
    this.ownPainter = painter;
    this.effects.suspended = painter !== null;
    this.changed.emit();
  }

  get mode(): GizmoMode {
    return this.gizmo.mode;
  }

  set mode(mode: GizmoMode) {
    this.gizmo.mode = mode;
    this.changed.emit();
  }

  get space(): GizmoSpace {
    return this.gizmo.space;
  }

  set space(space: GizmoSpace) {
    this.gizmo.space = space;
    this.changed.emit();
  }

  get snapping(): boolean {
    return this.gizmo.snapping;
  }

  set snapping(snapping: boolean) {
    this.gizmo.snapping = snapping;
    this.changed.emit();
  }

  get showGrid(): boolean {
    return this.helpers.showGrid;
  }

  set showGrid(show: boolean) {
    this.helpers.showGrid = show;
    this.changed.emit();
  }

  get showIcons(): boolean {
    return this.helpers.showIcons;
  }

  set showIcons(show: boolean) {
    this.helpers.showIcons = show;
    this.changed.emit();
  }

  /** Whether the ranges of all lights are drawn; else those of selected ones. */
  get showRanges(): boolean {
    return this.helpers.showRanges;
  }

  set showRanges(show: boolean) {
    this.helpers.showRanges = show;
    this.changed.emit();
  }

  /** Whether every frame is drawn, changed or not: to see frame rates. */
  get continuous(): boolean {
    return this.always;
  }

  set continuous(continuous: boolean) {
    this.always = continuous;
    this.changed.emit();
  }

  /** Whether figures of the frames lie over the picture. */
  get showStatistics(): boolean {
    return this.hasStatistics;
  }

  set showStatistics(show: boolean) {
    this.hasStatistics = show;
    this.changed.emit();
  }

  /** The selected camera, of which a small picture lies over the large one; null when there is none. */
  get previewed(): CameraComponent | null {
    const camera = this.document.selectedObjects.at(-1)?.getComponent(CameraComponent) ?? null;
    return camera === this.through ? null : camera;
  }

  /** The camera of the scene that is looked through; null for the editor's own. Only then does input go to the scene. */
  get lookThrough(): CameraComponent | null {
    return this.through;
  }

  set lookThrough(camera: CameraComponent | null) {
    this.through = camera;
    this.editorCamera.enabled = camera === null;
    this.changed.emit();
  }

  /** Whether pointer and keys go to the scene's own components. */
  get sceneListens(): boolean {
    return this.through !== null && this.document.simulation.isPlaying;
  }

  /** The three camera of the picture. */
  get camera(): Camera {
    return this.through?.isAttached ? this.through.three : this.editorCamera.camera;
  }

  /** Size of the picture in CSS pixels. */
  get size(): { width: number; height: number } {
    return { width: this.width, height: this.height };
  }

  /** Has the next frame drawn, and those that an effect gathers. */
  invalidate(): void {
    this.pending = this.effects.frames;
  }

  /** Sets what takes part in the picture beside the technique. */
  setEffects(choice: EffectChoice): void {
    this.effects.choice = choice;
  }

  /** Effects of plugins. */
  get addedEffects(): Registry<AddedEffect> {
    return this.effects.added;
  }

  /** Draws now. */
  renderNow(): void {
    this.through?.setViewport(this.width, this.height);
    followEffects(this.farol, this.document.scene, this.redraw);
    (this.painter ?? this.farol).render(this.document.scene.three, this.camera);
    this.gizmo.update(this.camera);
    if (this.view !== 'grid' && (this.painter?.drawsHelpers ?? true))
      this.helpers.render(this.webgl, this.camera, this.through, this.gizmo.isDragging);
    const { previewed } = this;
    if (previewed) {
      this.preview ??= this.makePreview();
      const { scene, edited } = this.document;
      const key = `${edited.revision} ${scene.time} ${this.assetChanges}`;
      this.preview.render(scene, previewed, this.width, this.height, key);
    }
    this.effects.update();
    this.statistics.add(performance.now());
    this.drawn.emit();
  }

  /**
   * The GameObject that is seen at a point of the picture: icons of lights and cameras before meshes.
   * @param point - normalised device coordinates
   */
  pick(point: Vector2): GameObject | null {
    const mesh = pick(this.document.scene, this.camera, point);
    const icon = this.helpers.pickIcon(this.camera, point, this.width, this.height);
    if (icon && (!mesh || icon.distance < mesh.distance + ICON_REACH)) return icon.object;
    return mesh?.object ?? null;
  }

  /** The GameObjects within a box of the picture (normalised device coordinates). See `pickBox`. */
  pickBox(box: Box2): GameObject[] {
    return pickBox(this.document.scene, this.camera, box);
  }

  /** Draws a ball of a material on a canvas of the page. @returns fulfilled when it is there */
  drawMaterial(material: Material, canvas: HTMLCanvasElement): Promise<void> {
    this.ball ??= new MaterialBall(this.webgl);
    return this.ball.draw(material, this.document.scene.three.environment, canvas);
  }

  /** Looks at the selection, or at everything. */
  focus(): void {
    const { selectedObjects, scene } = this.document;
    const box = boundsOf(selectedObjects.length > 0 ? selectedObjects : scene.roots);
    if (!box.isEmpty()) this.editorCamera.focus(box);
  }

  /** Puts the canvas into an element, whose size it follows. */
  attach(parent: HTMLElement): void {
    parent.append(this.canvas);
    this.resizer.observe(parent);
    this.resize();
  }

  /** Takes the canvas out of where it is. */
  detach(): void {
    this.resizer.disconnect();
    this.canvas.remove();
  }

  dispose(): void {
    cancelAnimationFrame(this.request);
    this.resizer.disconnect();
    for (const end of this.endings) end();
    this.picker.dispose();
    this.boxSelect.dispose();
    this.preview?.dispose();
    this.ball?.dispose();
    this.input.dispose();
    this.gizmo.dispose();
    this.helpers.dispose();
    this.editorCamera.dispose();
    this.ownPainter?.dispose();
    this.effects.dispose();
    this.farol.dispose();
    this.webgl.dispose();
  }

  private makePreview(): CameraPreview {
    const preview = new CameraPreview(this.webgl);
    this.shareMicroShaders(preview.microshaders);
    return preview;
  }

  private sceneOpened(): void {
    this.lookThrough = null;
    const { scene } = this.document;
    const { activeCamera } = scene;
    scene.three.updateMatrixWorld();
    if (!activeCamera) return this.editorCamera.focus(boundsOf(scene.roots), false);
    this.editorCamera.matchCamera(activeCamera, (camera) => hitPoint(scene, camera, middle)?.distance ?? null);
  }

  /** A camera that was taken out cannot be looked through. */
  private checkCamera(): void {
    if (this.through && !this.document.scene.componentsOf(CameraComponent).includes(this.through))
      this.lookThrough = null;
  }

  private resize(): void {
    const parent = this.canvas.parentElement;
    if (!parent) return;
    this.width = Math.max(1, parent.clientWidth);
    this.height = Math.max(1, parent.clientHeight);
    this.webgl.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.webgl.setSize(this.width, this.height);
    this.editorCamera.resize(this.width, this.height);
    this.resized.emit();
    // a canvas that was resized is empty until it is drawn
    this.renderNow();
  }

  private readonly redraw = (): void => this.invalidate();

  private readonly frame = (now: number): void => {
    this.request = requestAnimationFrame(this.frame);
    const elapsed = this.last === 0 ? 0 : (now - this.last) / 1000;
    this.last = now;
    const { simulation } = this.document;
    simulation.advance(elapsed);
    if (this.editorCamera.update(Math.min(elapsed, 0.1))) this.invalidate();
    if (!simulation.isPlaying && !this.always && this.pending === 0) {
      if (this.farol.updateTimes()) this.timed.emit();
      return;
    }
    this.pending = Math.max(0, this.pending - 1);
    try {
      this.renderNow();
    } catch (error) {
      this.onError(error);
    }
  };
}
