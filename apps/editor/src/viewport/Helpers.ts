import type { Camera as CameraComponent } from '@farol/engine';
import { type Camera, Scene, type Vector2, type WebGLRenderer } from 'three';
import type { EditorDocument } from '../model/EditorDocument';
import { Grid } from './Grid';
import { IconPoints } from './IconPoints';
import { LatePart } from './LatePart';
import type { PickHit } from './pick';
import type { SceneStamps } from './SceneStamps';
import type { SelectionLines } from './SelectionLines';

/**
 * Everything drawn over the viewport: grid, icons, lines of the selection, gizmo. A separate three scene rendered on
 * top with the scene's depth; the user's scene is not touched.
 */
export class Helpers {
  readonly scene = new Scene();
  /** Whether ranges of all lights are drawn, or only of selected ones. */
  showRanges = false;

  private readonly grid = new Grid();
  private readonly icons = new IconPoints();
  /** Lines of the selection and ranges; fetched once something is selected, or ranges are shown. */
  private readonly lines: LatePart<SelectionLines>;

  /**
   * @param stamps - counts of the scene's changes, by which needless updates of the icons are skipped
   * @param redraw - called when the picture must be drawn again
   * @param failed - called when the code of the selection's lines cannot be fetched
   */
  constructor(
    private readonly document: EditorDocument,
    private readonly stamps: SceneStamps,
    redraw: () => void,
    failed: (error: unknown) => void,
  ) {
    this.scene.add(this.grid, this.icons);
    this.lines = new LatePart(
      () => this.showRanges || document.selection.ids.length > 0,
      async () => {
        const { SelectionLines: Lines } = await import('./SelectionLines');
        return () => {
          redraw();
          return new Lines(document, this.scene);
        };
      },
      failed,
    );
  }

  get showGrid(): boolean {
    return this.grid.visible;
  }

  set showGrid(show: boolean) {
    this.grid.visible = show;
  }

  get showIcons(): boolean {
    return this.icons.visible;
  }

  set showIcons(show: boolean) {
    this.icons.visible = show;
  }

  /**
   * Draws grid, icons and lines over the frame just rendered with the same camera.
   * @param isDragging - whether the gizmo is being dragged: then only transforms change
   */
  render(webgl: WebGLRenderer, camera: Camera, lookThrough: CameraComponent | null, isDragging: boolean): void {
    if (this.icons.visible) this.icons.follow(this.document, this.stamps, webgl.getPixelRatio(), lookThrough);
    const { autoClear } = webgl;
    webgl.autoClear = false;
    this.lines.get()?.render(webgl, camera, lookThrough, this.showRanges, isDragging);
    this.grid.update(camera);
    webgl.render(this.scene, camera);
    webgl.autoClear = autoClear;
  }

  /**
   * The icon at a point (normalised device coordinates). @param width - viewport width (CSS pixels) @param height -
   * viewport height (CSS pixels)
   */
  pickIcon(camera: Camera, point: Vector2, width: number, height: number): PickHit | null {
    return this.icons.visible ? this.icons.pick(camera, point, width, height) : null;
  }

  dispose(): void {
    this.grid.dispose();
    this.icons.dispose();
    this.lines.dispose();
  }
}
