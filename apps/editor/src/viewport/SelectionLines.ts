import type { Camera as CameraComponent } from '@farol/engine';
import type { Camera, Scene, WebGLRenderer } from 'three';
import type { EditorDocument } from '../model/EditorDocument';
import { drawRanges, drawSelection } from './drawSelection';
import { LineSet } from './LineSet';
import { SelectionOutline } from './SelectionOutline';

/** Colour of lines around selected objects. */
const COLOUR = '#ff9d3c';

/** Colour of the ranges of lights that are not selected. */
const QUIET = '#8a7a5c';

/** The outline and lines of the selection, and the ranges of other lights. */
export class SelectionLines {
  private readonly lines = new LineSet(COLOUR);
  private readonly ranges = new LineSet(QUIET);
  private readonly outline = new SelectionOutline(COLOUR);
  private outlineKey = '';
  private rangesKey = 'none';

  /** @param helpers - scene that is drawn over the picture after `render` */
  constructor(
    private readonly document: EditorDocument,
    private readonly helpers: Scene,
  ) {
    helpers.add(this.ranges.three, this.lines.three);
  }

  /**
   * Draws the outline over the picture that was just drawn with the same camera, and updates the lines.
   * @param showsRanges - whether the ranges of all lights are drawn, not only of selected ones
   * @param isDragging - whether the gizmo is being dragged: then only transforms change
   */
  render(
    webgl: WebGLRenderer,
    camera: Camera,
    lookThrough: CameraComponent | null,
    showsRanges: boolean,
    isDragging: boolean,
  ): void {
    const { selection, selectedObjects, edited, assetsChanged } = this.document;
    this.refreshRanges(showsRanges);
    this.lines.begin();
    drawSelection(this.lines, selectedObjects, lookThrough);
    this.lines.end();
    if (!isDragging) {
      // the meshes of an object change when its asset is loaded
      this.outlineKey = `${selection.changed.revision} ${edited.revision} ${assetsChanged.revision}`;
    }
    this.outline.render(webgl, camera, selectedObjects, this.outlineKey);
  }

  dispose(): void {
    this.helpers.remove(this.ranges.three, this.lines.three);
    this.ranges.dispose();
    this.lines.dispose();
    this.outline.dispose();
  }

  /** Rebuilds the ranges when the scene may have changed. */
  private refreshRanges(showsRanges: boolean): void {
    const { scene, edited } = this.document;
    const key = showsRanges ? `${edited.revision} ${scene.time}` : '';
    if (key === this.rangesKey) return;
    this.rangesKey = key;
    this.ranges.begin();
    if (showsRanges) drawRanges(this.ranges, scene);
    this.ranges.end();
  }
}
