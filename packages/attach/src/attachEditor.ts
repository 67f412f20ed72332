import type { Camera, Object3D, WebGLRenderer } from 'three';
import { AttachedEditor } from './AttachedEditor';
import type { AttachOptions } from './AttachOptions';
import { languages } from './language/languages';

/**
 * Opens an editor over a running three.js page: the tree of its objects, an inspector of transform, flags, light, camera
 * and materials, a gizmo on the selected objects, undo, and a frame panel which can have the page drawn by Farol. The page
 * needs to know nothing of it. While the editor is there, it stands in for `renderer.render` of this one renderer; all
 * else is listened to, or drawn over the finished frame. `dispose()` takes all of that away; edits of the scene stay.
 *
 * @param camera - what the page looks through; set `camera` of the editor when that changes
 * @example
 * const editor = attachEditor(scene, camera, renderer);
 * editor.dispose();
 * @throws Error when an editor is attached to this renderer already, it is no WebGLRenderer, or the language is unknown
 */
export function attachEditor(
  scene: Object3D,
  camera: Camera,
  renderer: WebGLRenderer,
  options: AttachOptions = {},
): AttachedEditor {
  const { language } = options;
  if (language !== undefined && !Object.hasOwn(languages, language)) {
    const known = Object.keys(languages).join(', ');
    throw new Error(`attachEditor: unknown language "${String(language)}"; use one of: ${known}.`);
  }
  return new AttachedEditor(scene, camera, renderer, options);
}
