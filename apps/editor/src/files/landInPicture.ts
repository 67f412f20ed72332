import type { GameObject } from '@farol/engine';
import { Vector2 } from 'three';
import type { EditorApi } from '../api/EditorApi';
import { shapesToLoad } from '../viewport/placing/boundsOfNew';
import { land, type LandingView } from '../viewport/placing/land';

/** A page position (CSS pixels; the viewport's centre when absent) in the viewport's normalised device coordinates. */
export function pointInPicture({ viewport }: EditorApi, at?: { readonly x: number; readonly y: number }): Vector2 {
  if (!at) return new Vector2();
  // activates the one of four views that is under the point
  viewport.panes.activateAt(at.x, at.y);
  const { left, top, width, height } = viewport.bounds;
  return new Vector2(((at.x - left) / width) * 2 - 1, 1 - ((at.y - top) / height) * 2);
}

/** The viewport's state that placing objects depends on. */
export function landingView({ document, viewport }: EditorApi): LandingView {
  const { rayCamera: camera, editorCamera, snapping, snapTo, gizmo } = viewport;
  const step = snapping && snapTo === 'grid' ? gizmo.snapSteps.translate : 0.001;
  return { scene: document.scene, camera, target: editorCamera.target, step };
}

/** Loads what objects draw. @throws AssetError (as a rejection) when something cannot be loaded */
export async function loadShapes({ document }: EditorApi, objects: readonly GameObject[]): Promise<void> {
  const { assets } = document;
  const missing = shapesToLoad(objects, assets);
  if (missing.length > 0) await Promise.all(missing.map((name) => assets.load(name)));
}

/**
 * Places objects that are not in a scene yet in front of the camera, once their meshes are loaded. See `land`.
 * @param at - page position (CSS pixels); the centre of the viewport when absent
 * @throws AssetError (as a rejection) when something that they draw cannot be loaded
 */
export async function landInPicture(
  editor: EditorApi,
  objects: readonly GameObject[],
  at?: { readonly x: number; readonly y: number },
): Promise<void> {
  const { scene } = editor.document;
  await loadShapes(editor, objects);
  if (scene !== editor.document.scene) return;
  // computed before `landingView`: `pointInPicture` activates the view under the pointer, which `landingView` reads
  const point = pointInPicture(editor, at);
  land(landingView(editor), objects, point);
}
