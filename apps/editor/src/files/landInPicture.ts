import type { GameObject } from '@farol/engine';
import { Vector2 } from 'three';
import type { EditorApi } from '../api/EditorApi';
import { shapesToLoad } from '../viewport/placing/boundsOfNew';
import { land, type LandingView } from '../viewport/placing/land';

/** A point of the picture in normalised device coordinates. @param at - of the page (CSS pixels); the middle when absent */
export function pointInPicture({ viewport }: EditorApi, at?: { readonly x: number; readonly y: number }): Vector2 {
  if (!at) return new Vector2();
  // of several views the one at the point
  viewport.panes.activateAt(at.x, at.y);
  const { left, top, width, height } = viewport.bounds;
  return new Vector2(((at.x - left) / width) * 2 - 1, 1 - ((at.y - top) / height) * 2);
}

/** What placing needs to know of an editor's picture. */
export function landingView({ document, viewport }: EditorApi): LandingView {
  const { rayCamera: camera, editorCamera, snapping, snapTo, gizmo } = viewport;
  const step = snapping && snapTo === 'grid' ? gizmo.snapSteps.translate : 0.001;
  return { scene: document.scene, camera, target: editorCamera.target, step };
}

/**
 * Places objects that are in no scene yet where one looks, once what they draw is loaded. See `land`.
 * @param at - the point of the page (CSS pixels) that counts; the middle of the picture when absent
 * @throws AssetError (as a rejection) when what they draw cannot be loaded
 */
export async function landInPicture(
  editor: EditorApi,
  objects: readonly GameObject[],
  at?: { readonly x: number; readonly y: number },
): Promise<void> {
  const { scene, assets } = editor.document;
  const missing = shapesToLoad(objects, assets);
  if (missing.length > 0) await Promise.all(missing.map((name) => assets.load(name)));
  if (scene !== editor.document.scene) return;
  // first: it makes the view active that is landed in
  const point = pointInPicture(editor, at);
  land(landingView(editor), objects, point);
}
