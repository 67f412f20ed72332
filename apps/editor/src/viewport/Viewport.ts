import { Signal } from '@farol/editing';
import { type Camera as CameraComponent, createWebGLRenderer, type GameObject, PictureRenderer } from '@farol/engine';
import { FarolRenderer, type TechniqueName } from '@farol/renderer';
import type { MicroShaderRegistry } from '@farol/renderer/authoring';
import type { Box2, Camera, Material, Vector2, WebGLRenderer } from 'three';
import type { CameraView } from '../model/cameraEdits';
import type { EditorDocument } from '../model/EditorDocument';
import type { Registry } from '../model/Registry';
import { type AddedEffect, AddedEffects } from './AddedEffects';
import { BoxSelect } from './BoxSelect';
import { CameraPreview } from './CameraPreview';
import { CanvasPlace } from './CanvasPlace';
import type { EditorCamera } from './EditorCamera';
import { FrameLoop } from './FrameLoop';
import { FrameStatistics } from './FrameStatistics';
import { Gizmo } from './Gizmo';
import { Helpers } from './Helpers';
import { type BallTurn, MaterialBall } from './MaterialBall';
import { pick } from './pick';
import { pickBox } from './pickBox';
import type { Painter } from './Painter';
import { PaneDrawing, type PaneSurface } from './panes/PaneDrawing';
import { Panes } from './panes/Panes';
import { type Bounds, paneSurface } from './panes/paneSurface';
import { limitShare, type PaneShare } from './panes/PaneShare';
import type { ViewPane } from './panes/ViewPane';
import type { PickSurface } from './PickSurface';
import { LateParticlePreview } from './particles/LateParticlePreview';
import { LateLightHandles } from './lights/LateLightHandles';
import { LatePhysicsOverlay } from './physics/LatePhysicsOverlay';
import { PictureCamera } from './PictureCamera';
import { PlayView } from './PlayView';
import { PointerPicker } from './PointerPicker';
import { SceneInput } from './SceneInput';
import type { Shading } from './shading/Shading';
import { ViewportSettings } from './ViewportSettings';

/** Icons up to this much farther (m) than the mesh at the same point are picked before it. */
const ICON_REACH = 0.4;

/**
 * The picture of the document: canvas, camera, gizmo, picking, loop. It draws when something changed, each frame while
 * the scene plays, and always when `continuous` is set. It knows nothing of React.
 */
export class Viewport extends ViewportSettings implements PickSurface, PaneSurface {
  /** Takes what goes wrong while a frame is drawn. */
  onError: (error: unknown) => void = () => {};
  /** Brings the scene's microshaders into another renderer that draws the scene. */
  shareMicroShaders: (registry: MicroShaderRegistry) => void = () => {};
  /** Emits after each frame that was drawn. */
  readonly drawn = new Signal();
  /** GPU times of the last frame have come, after it: they are in `farol.info`. */
  readonly timed = new Signal();
  /** Emits when the picture has another size. */
  readonly resized = new Signal();
  /** The user asks for the menu of shadings. */
  readonly shadingAsked = new Signal();
  readonly statistics = new FrameStatistics();
  readonly webgl: WebGLRenderer;
  readonly farol: FarolRenderer;
  /** The views of the picture: one, or four. */
  readonly panes: Panes;
  readonly gizmo: Gizmo;
  readonly helpers: Helpers;
  /** Lines and handles of colliders and joints. */
  readonly physics: LatePhysicsOverlay;
  /** Handles of lights with a shape. */
  readonly lightHandles: LateLightHandles;
  /** Selected emitters, which play while the scene is stopped. */
  readonly particles: LateParticlePreview;
  readonly picker: PointerPicker;
  readonly boxSelect: BoxSelect;

  /** Draws by `farol` what the scene's settings say of the picture. */
  readonly picture: PictureRenderer;
  /** Pointer and keys of a scene that plays. */
  readonly input: SceneInput;

  private readonly added: AddedEffects;
  private readonly playView: PlayView;
  private preview: CameraPreview | null = null;
  private ball: MaterialBall | null = null;
  private readonly drawing = new PaneDrawing(this);
  private assetChanges = 0;
  private drawnBy: TechniqueName = 'auto';
  private readonly endings: (() => void)[] = [];
  private readonly pictureCamera: PictureCamera;
  private readonly place: CanvasPlace;
  protected readonly loop: FrameLoop;
  private ownPainter: Painter | null = null;

  /** @throws Error when the browser has no WebGL 2 */
  constructor(
    readonly document: EditorDocument,
    readonly canvas: HTMLCanvasElement,
  ) {
    super();
    this.loop = new FrameLoop({
      advance: (seconds) => this.advance(seconds),
      draw: () => this.renderNow(),
      failed: (error) => this.onError(error),
      rest: () => this.farol.updateTimes() && this.timed.emit(),
    });
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'img');
    this.webgl = createWebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.webgl.shadowMap.enabled = true;
    this.farol = new FarolRenderer(this.webgl, { timing: true });
    this.picture = new PictureRenderer(this.farol, { redraw: this.redraw, failed: (error) => this.onError(error) });
    this.added = new AddedEffects(this.picture.effects);
    const dragged = (isDragging: boolean): void => {
      this.editorCamera.enabled = !isDragging;
    };
    this.panes = new Panes(
      canvas,
      () => !this.keysGoToScene,
      () => this.paneActivated(),
    );
    const surface = paneSurface(canvas, () => this.panes.bounds);
    // the handles hear of the pointer before the camera does, so that a handle is taken and the camera stays
    this.gizmo = new Gizmo(document, surface, dragged, this.redraw, () => this.panes.listenLast());
    this.pictureCamera = new PictureCamera(document, this.panes.main.editorCamera, canvas);
    this.place = new CanvasPlace(canvas, () => this.resize());
    this.helpers = new Helpers(document);
    this.helpers.scene.add(this.gizmo.three);
    this.physics = new LatePhysicsOverlay(this, this.helpers.scene, (error) => this.onError(error));
    this.lightHandles = new LateLightHandles(this, this.helpers.scene, (error) => this.onError(error));
    this.particles = new LateParticlePreview(this, this.helpers.scene, (error) => this.onError(error));
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
    this.loop.start();
  }

  /** What draws the picture in place of `farol` alone; null for nothing. It is disposed when another one comes. */
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

  /** The selected camera, of which a small picture lies over the large one; null when there is none. */
  get previewed(): CameraComponent | null {
    return this.pictureCamera.selected;
  }

  /** The camera of the scene that is looked through; null for the editor's own. */
  get lookThrough(): CameraComponent | null {
    return this.pictureCamera.lookThrough;
  }

  set lookThrough(camera: CameraComponent | null) {
    this.pictureCamera.lookThrough = camera;
    this.changed.emit();
  }

  /** Why the camera that is looked through cannot be moved, in a sentence with the mend; null where it can. */
  get flightProblem(): string | null {
    return this.pictureCamera.flight.problem;
  }

  /** What the editor's own camera sees. */
  get viewed(): CameraView {
    return this.pictureCamera.view;
  }

  /** Whether the pointer goes to the scene's own components. */
  get sceneListens(): boolean {
    return this.input.hasPointer;
  }

  /** Whether keys go to the scene's own components. */
  get keysGoToScene(): boolean {
    return this.input.hasKeys;
  }

  /** Plays the scene, seen through a camera of it until it stops. @param isHere - whether from where the editor looks */
  playThrough(camera: CameraComponent, isHere: boolean): void {
    this.playView.play(camera, isHere ? this.viewed : null);
    this.input.takeKeys();
  }

  /** The editor's own camera of the active view. */
  get editorCamera(): EditorCamera {
    return this.panes.active.editorCamera;
  }

  /** The three camera of the active view. */
  get camera(): Camera {
    return this.cameraOf(this.panes.active);
  }

  /** The active view's part of the page. */
  get bounds(): Bounds {
    return this.panes.bounds;
  }

  /** Whether there are four views: from above, from the front, from the right, and the one there always is. */
  get isQuad(): boolean {
    return this.panes.isQuad;
  }

  set isQuad(isQuad: boolean) {
    if (isQuad === this.panes.isQuad) return;
    if (isQuad) this.painter = null;
    this.panes.isQuad = isQuad;
    this.changed.emit();
  }

  /** Says how four views share the picture. */
  shareViews(share: PaneShare): void {
    const { x, y } = limitShare(share);
    if (x === this.panes.share.x && y === this.panes.share.y) return;
    this.panes.share = share;
    this.invalidate();
  }

  /** How the active view shows the scene. */
  get shading(): Shading {
    return this.panes.active.shading;
  }

  /** Says how a view shows the scene. */
  shade(pane: ViewPane, shading: Shading): void {
    pane.shading = shading;
    this.changed.emit();
  }

  /** Sees the same as `camera`; rays that begin at its eye meet all that is seen. */
  get rayCamera(): Camera {
    return this.raysOf(this.panes.active);
  }

  /** Size of the picture in CSS pixels. */
  get size(): { width: number; height: number } {
    const { width, height } = this.place;
    return { width, height };
  }

  /** Height of the picture (CSS pixels). */
  get pictureHeight(): number {
    return this.place.height;
  }

  /** Has the next frame drawn, and those that an effect gathers. */
  invalidate(): void {
    this.loop.ask(this.picture.effects.frames);
  }

  /** Effects of plugins. */
  get addedEffects(): Registry<AddedEffect> {
    return this.added.registry;
  }

  /** Draws now. */
  renderNow(): void {
    const { width, height } = this.place;
    const { list, active } = this.panes;
    const { scene } = this.document;
    this.picture.follow(scene);
    if (list.length > 1) this.webgl.clear();
    for (let i = 0; i < list.length; i++) if (list[i] !== active) this.drawing.draw(list[i]);
    // last, since the handles are taken where they were drawn last
    this.drawing.draw(active);
    if (list.length > 1) {
      this.webgl.setScissorTest(false);
      this.webgl.setViewport(0, 0, width, height);
    }
    this.picture.effects.update(scene.settings);
    this.noticeTechnique();
    const { previewed } = this;
    if (previewed) {
      this.preview ??= this.makePreview();
      const { edited } = this.document;
      const key = `${edited.revision} ${scene.time} ${this.assetChanges}`;
      this.preview.render(scene, previewed, width, height, key);
    }
    this.statistics.add(performance.now());
    this.drawn.emit();
  }

  /**
   * The GameObject that is seen at a point of the picture: icons of lights and cameras before meshes.
   * @param point - normalised device coordinates
   */
  pick(point: Vector2): GameObject | null {
    const mesh = pick(this.document.scene, this.rayCamera, point);
    const { width, height } = this.panes.active.rectangle;
    const icon = this.helpers.pickIcon(this.rayCamera, point, width, height);
    if (icon && (!mesh || icon.distance < mesh.distance + ICON_REACH)) return icon.object;
    return mesh?.object ?? null;
  }

  /** The GameObjects within a box of the picture (normalised device coordinates). See `pickBox`. */
  pickBox(box: Box2): GameObject[] {
    return pickBox(this.document.scene, this.camera, box);
  }

  /**
   * Draws a ball of a material on a canvas of the page.
   * @param turn - how the ball is turned: to the right and up (rad)
   * @returns fulfilled when it is there
   */
  drawMaterial(material: Material, canvas: HTMLCanvasElement, turn: BallTurn = [0, 0]): Promise<void> {
    this.ball ??= new MaterialBall(this.webgl);
    return this.ball.draw(material, this.document.scene.three.environment, canvas, turn);
  }

  /** Looks at the selection, or at everything. */
  focus(): void {
    this.pictureCamera.focus(this.editorCamera);
  }

  /** The editor's own camera looks otherwise: draws, and tells. */
  viewChanged(): void {
    this.changed.emit();
  }

  /** Brings the editor's own camera to where a camera of the scene is. */
  alignTo(camera: CameraComponent): void {
    this.lookThrough = null;
    this.pictureCamera.match(camera);
    this.invalidate();
  }

  /** Puts the canvas into an element, whose size it follows. */
  attach(parent: HTMLElement): void {
    this.place.attach(parent);
  }

  /** Takes the canvas out of where it is. */
  detach(): void {
    this.place.detach();
  }

  dispose(): void {
    this.loop.stop();
    this.place.dispose();
    for (const end of this.endings) end();
    this.picker.dispose();
    this.boxSelect.dispose();
    this.physics.dispose();
    this.lightHandles.dispose();
    this.particles.dispose();
    this.preview?.dispose();
    this.ball?.dispose();
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

  /** The three camera that a view is drawn by. */
  cameraOf(pane: ViewPane): Camera {
    return pane === this.panes.main ? this.pictureCamera.current : pane.editorCamera.camera;
  }

  /** Sees the same as the camera of a view; rays that begin at its eye meet all that is seen there. */
  raysOf(pane: ViewPane): Camera {
    return pane === this.panes.main ? this.pictureCamera.rays : pane.editorCamera.rayCamera;
  }

  /** The handles are where the active view has them. */
  private paneActivated(): void {
    this.gizmo.update(this.rayCamera);
    this.helpers.scene.updateMatrixWorld();
    this.changed.emit();
  }

  private makePreview(): CameraPreview {
    const preview = new CameraPreview(this.webgl, this.redraw);
    this.shareMicroShaders(preview.microshaders);
    return preview;
  }

  private sceneOpened(): void {
    this.lookThrough = null;
    this.pictureCamera.showScene();
    this.panes.lookFromSides();
  }

  /** Another scene, or a step of the history, may have brought another technique. */
  private noticeTechnique(): void {
    const { technique } = this.farol;
    if (technique === this.drawnBy) return;
    this.drawnBy = technique;
    this.changed.emit();
  }

  /** A camera that was taken out cannot be looked through. */
  private checkCamera(): void {
    if (this.pictureCamera.isLost) this.lookThrough = null;
  }

  private resize(): void {
    const { width, height } = this.place;
    this.webgl.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.webgl.setSize(width, height);
    this.panes.resize(width, height);
    this.resized.emit();
    // a canvas that was resized is empty until it is drawn
    this.renderNow();
  }

  private readonly redraw = (): void => this.invalidate();

  /** @returns whether a frame is to be drawn for what moves by itself */
  private advance(seconds: number): boolean {
    const { simulation } = this.document;
    simulation.advance(seconds);
    const step = Math.min(seconds, 0.1);
    const moved = this.pictureCamera.update(step);
    if (this.panes.update(step) || moved) this.invalidate();
    return this.particles.advance(seconds) || simulation.isPlaying;
  }
}
