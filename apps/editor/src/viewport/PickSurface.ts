import type { GameObject, Scene } from '@farol/engine';
import type { Camera, Vector2 } from 'three';
import type { Selection } from '../model/Selection';
import type { EditorCamera } from './EditorCamera';
import type { GizmoMode } from './Gizmo';
import type { Bounds } from './panes/paneSurface';

/** The part of the viewport that selection by pointer uses. */
export interface PickSurface {
  readonly canvas: HTMLCanvasElement;
  readonly document: { readonly scene: Scene; readonly selection: Selection };
  readonly editorCamera: EditorCamera;
  /** `isHot`: whether the pointer is over a handle. */
  readonly gizmo: { readonly isHot: boolean };
  readonly mode: GizmoMode;
  /** Rectangle of the active view on the page. */
  readonly bounds: Bounds;
  /** three's camera of the active view. */
  readonly camera: Camera;
  readonly onError: (error: unknown) => void;
  /** The visible GameObject at a point. @param point - normalised device coordinates */
  pick(point: Vector2): GameObject | null;
}
