import type { EditorCamera } from '../EditorCamera';
import type { Shading } from '../shading/Shading';

/** Part of the picture: CSS pixels, from its left upper corner. */
export interface PaneRectangle {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

/** A part of the picture with a view of its own. */
export interface ViewPane {
  /** 'main' is the one with perspective, which a camera of the scene can be looked through in. */
  readonly name: 'main' | 'top' | 'front' | 'right';
  readonly editorCamera: EditorCamera;
  rectangle: PaneRectangle;
  shading: Shading;
}
