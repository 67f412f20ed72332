import type { ViewInfo } from '@farol/renderer';
import { EditorCamera } from '../EditorCamera';
import type { Shading } from '../shading/Shading';
import { type Bounds, paneSurface } from './paneSurface';

/** Rectangle in the viewport (CSS pixels from the upper left corner). */
export interface PaneRectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A part of the viewport with a camera and a shading of its own. */
export class ViewPane {
  rectangle: PaneRectangle = { x: 0, y: 0, width: 1, height: 1 };
  readonly editorCamera: EditorCamera;
  /** `FarolInfo.view` of the pane's last frame; null when it shows no buffer. */
  shown: ViewInfo | null = null;

  /**
   * @param name - 'main' always exists, and can show the view of a scene's camera
   * @param shading - shading of the scene
   * @param hasKeys - called at each key press: whether the camera controls may use the key
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

  /** Rectangle of the view on the page (CSS pixels). */
  get bounds(): Bounds {
    const { x, y, width, height } = this.rectangle;
    const { left, top } = this.canvas.getBoundingClientRect();
    return { left: left + x, top: top + y, width, height };
  }
}
