import type { Camera as CameraComponent, Scene as EngineScene } from '@farol/engine';
import { type Camera, Scene, type Vector2, type WebGLRenderer } from 'three';
import type { EditorDocument } from '../model/EditorDocument';
import { drawRanges, drawSelection } from './drawSelection';
import { Grid } from './Grid';
import { IconPoints } from './IconPoints';
import { LineSet } from './LineSet';
import { SelectionOutline } from './SelectionOutline';
import type { PickHit } from './pick';

/** Of what is selected. */
const COLOUR = '#ff9d3c';

/** Of the ranges of lights that are not. */
const QUIET = '#8a7a5c';

/**
 * What the editor draws over the picture: grid, icons, the selection's lines, the gizmo. It is a scene of its own, drawn
 * by three's renderer into the finished picture, with its depth; the user's scene is not touched.
 */
export class Helpers {
  readonly scene = new Scene();
  /** Whether the ranges of all lights are drawn, not of selected ones alone. */
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
    // what is loaded late is there late
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
   * Draws over the picture that was just drawn with the same camera.
   * @param isDragging - whether the gizmo is at work: nothing but transforms changes then
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

  /** The icon at a point of the picture (normalised device coordinates), whose size is in CSS pixels. */
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

  /** Found anew when the scene may have changed. */
  private refreshRanges(scene: EngineScene): void {
    const key = this.showRanges ? `${this.document.edited.revision} ${scene.time}` : '';
    if (key === this.rangesKey) return;
    this.rangesKey = key;
    this.ranges.begin();
    if (this.showRanges) drawRanges(this.ranges, scene);
    this.ranges.end();
  }
}
