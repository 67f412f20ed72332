import { EditorCamera } from '../EditorCamera';
import type { Shading } from '../shading/Shading';
import { type Bounds, paneSurface } from './paneSurface';

/** Part of the picture: CSS pixels, from its left upper corner. */
export interface PaneRectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A part of the picture with a view of its own. */
export class ViewPane {
  rectangle: PaneRectangle = { x: 0, y: 0, width: 1, height: 1 };
  readonly editorCamera: EditorCamera;

  /**
   * @param name - 'main' is the one that there always is, in which a camera of the scene can be looked through
   * @param shading - how it shows the scene
   * @param hasKeys - whether keys are the controls', asked at each
   */
  constructor(
    readonly name: 'main' | 'top' | 'front' | 'right',
    public shading: Shading,
    private readonly canvas: HTMLCanvasElement,
    hasKeys: () => boolean,
  ) {
    this.editorCamera = new EditorCamera(
      paneSurface(canvas, () => this.bounds),
      hasKeys,
    );
  }

  /** Its part of the page. */
  get bounds(): Bounds {
    const { x, y, width, height } = this.rectangle;
    const { left, top } = this.canvas.getBoundingClientRect();
    return { left: left + x, top: top + y, width, height };
  }
}
