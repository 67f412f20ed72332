import type { Camera as CameraComponent, Scene as EngineScene } from '@farol/engine';
import { type Camera, Scene, type Vector2, type WebGLRenderer } from 'three';
import type { EditorDocument } from '../model/EditorDocument';
import { drawRanges, drawSelection } from './drawSelection';
import { Grid } from './Grid';
import { IconPoints } from './IconPoints';
import { LineSet } from './LineSet';
import { SelectionOutline } from './SelectionOutline';
import type { PickHit } from './pick';

/** Colour of lines for selected objects. */
const COLOUR = '#ff9d3c';

/** Colour of ranges of lights that are not selected. */
const QUIET = '#8a7a5c';

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
  private readonly lines = new LineSet(COLOUR);
  private readonly ranges = new LineSet(QUIET);
  private readonly outline = new SelectionOutline(COLOUR);
  private outlineKey = '';
  private rangesKey = 'none';

  private assetChanges = 0;
  private readonly endAssets: () => void;

  constructor(private readonly document: EditorDocument) {
    this.scene.add(this.grid, this.icons, this.ranges.three, this.lines.three);
    // meshes that finish loading must be drawn too
    this.endAssets = document.assets.onChange(() => this.assetChanges++);
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
   * Draws over the frame just rendered with the same camera.
   * @param isDragging - whether the gizmo is being dragged: then only transforms change
   */
  render(webgl: WebGLRenderer, camera: Camera, lookThrough: CameraComponent | null, isDragging: boolean): void {
    const { scene, selection, selectedObjects } = this.document;
    if (this.icons.visible) {
      const selected = new Set(selection.ids);
      this.icons.refresh(scene, ({ id }) => selected.has(id), webgl.getPixelRatio(), lookThrough);
    }
    this.refreshRanges(scene);
    this.lines.begin();
    drawSelection(this.lines, selectedObjects, lookThrough);
    this.lines.end();
    const { autoClear } = webgl;
    webgl.autoClear = false;
    if (!isDragging) {
      const { edited } = this.document;
      this.outlineKey = `${selection.changed.revision} ${edited.revision} ${this.assetChanges}`;
    }
    this.outline.render(webgl, camera, selectedObjects, this.outlineKey);
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
    this.ranges.dispose();
    this.lines.dispose();
    this.outline.dispose();
    this.endAssets();
  }

  /** Rebuilds the ranges of lights when the scene may have changed. */
  private refreshRanges(scene: EngineScene): void {
    const key = this.showRanges ? `${this.document.edited.revision} ${scene.time}` : '';
    if (key === this.rangesKey) return;
    this.rangesKey = key;
    this.ranges.begin();
    if (this.showRanges) drawRanges(this.ranges, scene);
    this.ranges.end();
  }
}
