import { Signal } from '@farol/editing';
import { type Camera as CameraComponent, createWebGLRenderer, type GameObject, PictureRenderer } from '@farol/engine';
import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import type { MicroShaderRegistry } from '@farol/renderer/authoring';
import type { Camera, Material, Vector2, WebGLRenderer } from 'three';
import type { CameraView } from '../model/cameraEdits';
import type { EditorDocument } from '../model/EditorDocument';
import type { Registry } from '../model/Registry';
import { type AddedEffect, AddedEffects } from './AddedEffects';
import { BoxSelect } from './BoxSelect';
import { CanvasPlace } from './CanvasPlace';
import type { EditorCamera } from './EditorCamera';
import { FrameLoop } from './FrameLoop';
import { FrameStatistics } from './FrameStatistics';
import { Gizmo } from './Gizmo';
import { Helpers } from './Helpers';
import { LateParts } from './LateParts';
import type { BallTurn } from './MaterialBall';
import { iconOrMesh, pick } from './pick';
import type { Painter } from './Painter';
import { PaneDrawing, type PaneSurface } from './panes/PaneDrawing';
import { Panes } from './panes/Panes';
import { type Bounds, paneSurface } from './panes/paneSurface';
import type { ViewPane } from './panes/ViewPane';
import type { PickSurface } from './PickSurface';
import { PictureCamera } from './PictureCamera';
import { PlayView } from './PlayView';
import { PointerPicker } from './PointerPicker';
import { SceneInput } from './SceneInput';
import { SceneStamps } from './SceneStamps';
import type { Shading } from './shading/Shading';
import { ViewportSettings } from './ViewportSettings';

/**
 * The viewport of the document: canvas, cameras, gizmo, picking and render loop, without React. Draws when something
 * changed, each frame while the scene plays, and always when `continuous` is set.
 */
export class Viewport extends ViewportSettings implements PickSurface, PaneSurface {
  /** Called with errors thrown while a frame is drawn. */
  onError: (error: unknown) => void = () => {};
  /** Adds the scene's microshaders to another renderer that draws the scene. */
  shareMicroShaders: (registry: MicroShaderRegistry) => void = () => {};
  /** Emits after each drawn frame. */
  readonly drawn = new Signal();
  /** Emits when GPU times of the last frame are in `farol.info`, some time after it was drawn. */
  readonly timed = new Signal();
  readonly resized = new Signal();
  /** Emits when the user asks for the menu of shadings. */
  readonly shadingAsked = new Signal();
  readonly statistics = new FrameStatistics();
  readonly webgl: WebGLRenderer;
  readonly farol: FarolRenderer;
  /** The views of the viewport: one, or four. */
  readonly panes: Panes;
  readonly gizmo: Gizmo;
  readonly helpers: Helpers;
  /** Code that is fetched when it is first needed. */
  readonly parts: LateParts;
  readonly picker: PointerPicker;
  readonly boxSelect: BoxSelect;

  /** Renders the scene with `farol` and the effects of the scene's settings. */
  readonly picture: PictureRenderer;
  /** Sends pointer and keys to a playing scene. */
  readonly input: SceneInput;

  private readonly added: AddedEffects;
  private readonly playView: PlayView;
  private readonly drawing = new PaneDrawing(this);
  private drawnBy: TechniqueName = 'auto';
  private readonly endings: (() => void)[] = [];
  private readonly pictureCamera: PictureCamera;
  private readonly place: CanvasPlace;
  readonly loop: FrameLoop;
  /** Counts of the scene's changes, by which a frame leaves out unneeded work. */
  readonly stamps: SceneStamps;
  private ownPainter: Painter | null = null;

  /** @throws Error when the browser has no WebGL 2 */
  constructor(
    readonly document: EditorDocument,
    readonly canvas: HTMLCanvasElement,
  ) {
    super();
    const failed = (error: unknown): void => this.onError(error);
    this.stamps = new SceneStamps(document, this.ask);
    const { redraw } = this.stamps;
    this.loop = new FrameLoop({
      advance: (seconds) => this.advance(seconds),
      draw: () => this.drawFrame(),
      frames: () => this.picture.effects.frames,
      failed,
      rest: () => this.farol.updateTimes() && this.timed.emit(),
    });
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    this.webgl = createWebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.webgl.shadowMap.enabled = true;
    this.farol = new FarolRenderer(this.webgl, { timing: true });
    this.picture = new PictureRenderer(this.farol, { redraw, failed });
    this.added = new AddedEffects(this.picture.effects);
    const dragged = (isDragging: boolean): void => void (this.editorCamera.enabled = !isDragging);
    this.panes = new Panes(
      canvas,
      () => !this.keysGoToScene,
      () => this.paneActivated(),
    );
    const surface = paneSurface(canvas, () => this.panes.bounds);
    // the handles must receive pointer events before the camera, which then stays still
    this.gizmo = new Gizmo(document, surface, dragged, redraw, () => this.panes.listenLast());
    this.pictureCamera = new PictureCamera(document, this.panes.main.editorCamera, canvas, failed);
    this.place = new CanvasPlace(canvas, () => this.resize());
    this.helpers = new Helpers(document, this.stamps, redraw, failed);
    this.helpers.scene.add(this.gizmo.three);
    this.parts = new LateParts(this);
    this.boxSelect = new BoxSelect(this);
    this.picker = new PointerPicker(this);
    this.input = new SceneInput(
      document,
      canvas,
      surface,
      () => this.rayCamera,
      () => this.lookThrough !== null,
      () => this.changed.emit(),
    );
    this.playView = new PlayView(document, this);
    this.endings.push(
      this.changed.subscribe(this.ask),
      document.opened.subscribe(() => this.sceneOpened()),
      document.structure.subscribe(() => {
        // a camera that was removed has no view
        if (this.pictureCamera.isLost) this.lookThrough = null;
      }),
    );
    canvas.addEventListener('webglcontextrestored', redraw);
    this.loop.start();
  }

  /** Replaces normal rendering; null for none. Disposed when replaced. */
  get painter(): Painter | null {
    return this.ownPainter;
  }

  set painter(painter: Painter | null) {
    if (painter === this.ownPainter) return;
    this.ownPainter?.dispose();
    this.ownPainter = painter;
    if (painter) this.panes.isQuad = false;
    this.picture.effects.suspended = painter !== null;
    this.changed.emit();
  }

  /** The selected camera, whose view is shown as an inset; null when there is none. */
  get previewed(): CameraComponent | null {
    return this.isPlayed ? null : this.pictureCamera.selected;
  }

  /** Whether the scene is shown as its players see it: without grid, icons, handles and insets. */
  get isPlayed(): boolean {
    return this.playView.isOn;
  }

  /** The scene's camera whose view is shown; null for the editor's own. */
  get lookThrough(): CameraComponent | null {
    return this.pictureCamera.lookThrough;
  }

  set lookThrough(camera: CameraComponent | null) {
    this.pictureCamera.lookThrough = camera;
    this.changed.emit();
  }

  /** Why the shown camera cannot be moved, in a sentence with the remedy; null when it can. */
  get flightProblem(): string | null {
    return this.pictureCamera.problem;
  }

  get viewed(): CameraView {
    return this.pictureCamera.view;
  }

  /** Whether pointer events go to components of the scene. */
  get sceneListens(): boolean {
    return this.input.hasPointer;
  }

  /** Whether keys go to components of the scene. */
  get keysGoToScene(): boolean {
    return this.input.hasKeys;
  }

  /**
   * Plays the scene, showing the view of one of its cameras until it stops. @param isHere - whether the camera starts
   * at the editor's view
   */
  playThrough(camera: CameraComponent, isHere: boolean): void {
    this.playView.play(camera, isHere ? this.viewed : null);
    this.input.takeKeys();
  }

  /** The editor's camera of the active view. */
  get editorCamera(): EditorCamera {
    return this.panes.active.editorCamera;
  }

  /** The three camera of the active view. */
  get camera(): Camera {
    return this.cameraOf(this.panes.active);
  }

  get bounds(): Bounds {
    return this.panes.bounds;
  }

  get isQuad(): boolean {
    return this.panes.isQuad;
  }

  set isQuad(isQuad: boolean) {
    if (isQuad === this.panes.isQuad) return;
    if (isQuad) this.painter = null;
    this.panes.isQuad = isQuad;
    this.changed.emit();
  }

  get shading(): Shading {
    return this.panes.active.shading;
  }

  shade(pane: ViewPane, shading: Shading): void {
    pane.shading = shading;
    this.changed.emit();
  }

  /** Camera for raycasting in the active view, see `EditorCamera.rayCamera`. */
  get rayCamera(): Camera {
    return this.raysOf(this.panes.active);
  }

  /** Size of the viewport (CSS pixels). */
  get size(): { width: number; height: number } {
    const { width, height } = this.place;
    return { width, height };
  }

  /** Requests the next frame, and the frames that temporal effects need to converge; objects may have moved. */
  invalidate(): void {
    this.stamps.redraw();
  }

  get addedEffects(): Registry<AddedEffect> {
    return this.added.registry;
  }

  /** Draws a frame at once; objects may have moved. */
  renderNow(): void {
    this.stamps.move();
    this.drawFrame();
  }

  private drawFrame(): void {
    const { width, height } = this.place;
    this.picture.follow(this.document.scene);
    this.drawing.drawAll(width, height);
    this.picture.effects.update(this.document.scene.settings);
    this.noticeTechnique();
    this.parts.drawPreview(width, height);
    this.statistics.add(performance.now());
    this.drawn.emit();
  }

  /**
   * The visible GameObject at a point of the active view. Icons of lights and cameras come before meshes.
   * @param point - normalised device coordinates
   */
  pick(point: Vector2): GameObject | null {
    const mesh = pick(this.document.scene, this.rayCamera, point);
    const { width, height } = this.panes.active.rectangle;
    const icon = this.isPlayed ? null : this.helpers.pickIcon(this.rayCamera, point, width, height);
    return iconOrMesh(icon, mesh);
  }

  /**
   * Renders a sphere with a material to a canvas of the page.
   * @param turn - rotation of the sphere to the right and up (rad)
   * @returns fulfilled when the image is there
   * @throws Error (as a rejection) when the code for it cannot be fetched
   */
  drawMaterial(material: Material, canvas: HTMLCanvasElement, turn: BallTurn = [0, 0]): Promise<void> {
    return this.parts.drawBall(material, this.document.scene.three.environment, canvas, turn);
  }

  focus(): void {
    this.pictureCamera.focus(this.editorCamera);
  }

  /** Called when the editor's view changes: redraws and emits `changed`. */
  viewChanged(): void {
    this.changed.emit();
  }

  alignTo(camera: CameraComponent): void {
    this.lookThrough = null;
    this.pictureCamera.match(camera);
    this.invalidate();
  }

  /** Adds the canvas to an element, and follows its size. */
  attach(parent: HTMLElement): void {
    this.place.attach(parent);
  }

  detach(): void {
    this.place.detach();
  }

  dispose(): void {
    this.loop.stop();
    this.place.dispose();
    for (const end of this.endings) end();
    this.stamps.dispose();
    this.picker.dispose();
    this.boxSelect.dispose();
    this.parts.dispose();
    this.input.dispose();
    this.playView.dispose();
    this.gizmo.dispose();
    this.helpers.dispose();
    this.pictureCamera.dispose();
    this.panes.dispose();
    this.drawing.dispose();
    this.ownPainter?.dispose();
    this.picture.dispose();
    this.farol.dispose();
    this.webgl.dispose();
  }

  /** The three camera that a view is rendered with. */
  cameraOf(pane: ViewPane): Camera {
    return pane === this.panes.main ? this.pictureCamera.current : pane.editorCamera.camera;
  }

  /** Camera for raycasting in a view, see `EditorCamera.rayCamera`. */
  raysOf(pane: ViewPane): Camera {
    return pane === this.panes.main ? this.pictureCamera.rays : pane.editorCamera.rayCamera;
  }

  /** Moves the handles to where the newly active view shows them. */
  private paneActivated(): void {
    this.gizmo.update(this.rayCamera);
    this.helpers.scene.updateMatrixWorld();
    this.changed.emit();
  }

  private sceneOpened(): void {
    this.lookThrough = null;
    this.pictureCamera.showScene();
    this.panes.lookFromSides();
  }

  /** Emits `changed` if the technique differs from that of the last call. */
  private noticeTechnique(): void {
    const { technique } = this.farol;
    if (technique === this.drawnBy) return;
    this.drawnBy = technique;
    this.changed.emit();
  }

  private resize(): void {
    const { width, height } = this.place;
    this.webgl.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.webgl.setSize(width, height);
    this.panes.resize(width, height);
    this.resized.emit();
    // a resized canvas is blank until drawn
    this.renderNow();
  }

  /** Requests frames for a change that moves no object. */
  private readonly ask = (): void => this.loop.ask(this.picture.effects.frames);

  /** Advances time. @returns whether a frame must be drawn */
  private advance(seconds: number): boolean {
    const { simulation } = this.document;
    simulation.advance(seconds);
    const step = Math.min(seconds, 0.1);
    const moved = this.pictureCamera.update(step);
    if (this.panes.update(step) || moved) this.ask();
    const goesOn = (this.parts.particles.get()?.advance(seconds) ?? false) || simulation.isPlaying;
    if (goesOn || this.loop.continuous || simulation.state !== 'stopped') this.stamps.move();
    return goesOn;
  }
}
