import { Signal } from '@farol/editing';
import {
  type Camera as CameraComponent,
  createWebGLRenderer,
  type GameObject,
  InputRouter,
  PictureRenderer,
} from '@farol/engine';
import { FarolRenderer, type MicroShaderRegistry, type TechniqueName } from '@farol/renderer';
import { type Box2, type Camera, type Material, type Vector2, type WebGLRenderer } from 'three';
import type { EditorDocument } from '../model/EditorDocument';
import type { Registry } from '../model/Registry';
import { type AddedEffect, AddedEffects } from './AddedEffects';
import { BoxSelect } from './BoxSelect';
import { CameraPreview } from './CameraPreview';
import { CanvasPlace } from './CanvasPlace';
import { EditorCamera } from './EditorCamera';
import { FrameLoop } from './FrameLoop';
import { FrameStatistics } from './FrameStatistics';
import { Gizmo } from './Gizmo';
import { Helpers } from './Helpers';
import { MaterialBall } from './MaterialBall';
import { pick } from './pick';
import { pickBox } from './pickBox';
import type { Painter } from './Painter';
import type { PickSurface } from './PickSurface';
import { PictureCamera } from './PictureCamera';
import { PointerPicker } from './PointerPicker';
import { ViewportSettings } from './ViewportSettings';

/** Icons up to this much farther (m) than the mesh at the same point are picked before it. */
const ICON_REACH = 0.4;

/**
 * The picture of the document: canvas, camera, gizmo, picking, loop. It draws when something changed, each frame while
 * the scene plays, and always when `continuous` is set. It knows nothing of React.
 */
export class Viewport extends ViewportSettings implements PickSurface {
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
  readonly statistics = new FrameStatistics();
  readonly webgl: WebGLRenderer;
  readonly farol: FarolRenderer;
  readonly editorCamera: EditorCamera;
  readonly gizmo: Gizmo;
  readonly helpers: Helpers;
  readonly picker: PointerPicker;
  readonly boxSelect: BoxSelect;

  /** Draws by `farol` what the scene's settings say of the picture. */
  readonly picture: PictureRenderer;

  private readonly added: AddedEffects;
  private readonly input: InputRouter;
  private preview: CameraPreview | null = null;
  private ball: MaterialBall | null = null;
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
    canvas.setAttribute('aria-label', 'Picture of the scene: arrow keys turn it, plus and minus bring it nearer');
    this.webgl = createWebGLRenderer({ canvas, antialias: true, powerPreference: 'high-performance' });
    this.webgl.shadowMap.enabled = true;
    this.farol = new FarolRenderer(this.webgl, { timing: true });
    this.picture = new PictureRenderer(this.farol, { redraw: this.redraw, failed: (error) => this.onError(error) });
    this.added = new AddedEffects(this.picture.effects);
    const dragged = (isDragging: boolean): void => {
      this.editorCamera.enabled = !isDragging && this.lookThrough === null;
    };
    // the handles hear of the pointer before the camera does, so that a handle is taken and the camera stays
    const loaded = (): void => this.editorCamera.listenLast();
    this.gizmo = new Gizmo(document, canvas, dragged, this.redraw, loaded);
    this.editorCamera = new EditorCamera(canvas);
    this.pictureCamera = new PictureCamera(document, this.editorCamera);
    this.place = new CanvasPlace(canvas, () => this.resize());
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
    this.picture.effects.suspended = painter !== null;
    this.changed.emit();
  }

  /** The selected camera, of which a small picture lies over the large one; null when there is none. */
  get previewed(): CameraComponent | null {
    return this.pictureCamera.selected;
  }

  /** The camera of the scene that is looked through; null for the editor's own. Only then does input go to the scene. */
  get lookThrough(): CameraComponent | null {
    return this.pictureCamera.lookThrough;
  }

  set lookThrough(camera: CameraComponent | null) {
    this.pictureCamera.lookThrough = camera;
    this.changed.emit();
  }

  /** Whether pointer and keys go to the scene's own components. */
  get sceneListens(): boolean {
    return this.lookThrough !== null && this.document.simulation.isPlaying;
  }

  /** The three camera of the picture. */
  get camera(): Camera {
    return this.pictureCamera.current;
  }

  /** Size of the picture in CSS pixels. */
  get size(): { width: number; height: number } {
    const { width, height } = this.place;
    return { width, height };
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
    this.lookThrough?.setViewport(width, height);
    const { painter, picture } = this;
    const { scene } = this.document;
    if (painter === null) picture.render(scene, this.camera, this.lookThrough);
    else picture.renderBy(painter, scene, this.camera, this.lookThrough);
    this.noticeTechnique();
    this.gizmo.update(this.camera);
    if (this.view !== 'grid' && (this.painter?.drawsHelpers ?? true))
      this.helpers.render(this.webgl, this.camera, this.lookThrough, this.gizmo.isDragging);
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
    const mesh = pick(this.document.scene, this.camera, point);
    const icon = this.helpers.pickIcon(this.camera, point, this.place.width, this.place.height);
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
    this.pictureCamera.focus();
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
    this.preview?.dispose();
    this.ball?.dispose();
    this.input.dispose();
    this.gizmo.dispose();
    this.helpers.dispose();
    this.editorCamera.dispose();
    this.ownPainter?.dispose();
    this.picture.dispose();
    this.farol.dispose();
    this.webgl.dispose();
  }

  private makePreview(): CameraPreview {
    const preview = new CameraPreview(this.webgl, this.redraw);
    this.shareMicroShaders(preview.microshaders);
    return preview;
  }

  private sceneOpened(): void {
    this.lookThrough = null;
    this.pictureCamera.showScene();
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
    this.editorCamera.resize(width, height);
    this.resized.emit();
    // a canvas that was resized is empty until it is drawn
    this.renderNow();
  }

  private readonly redraw = (): void => this.invalidate();

  /** @returns whether a frame is to be drawn for what moves by itself */
  private advance(seconds: number): boolean {
    const { simulation } = this.document;
    simulation.advance(seconds);
    if (this.editorCamera.update(Math.min(seconds, 0.1))) this.invalidate();
    return simulation.isPlaying;
  }
}
