import type { Camera, Object3D, WebGLRenderer } from 'three';
import { AttachedEditor } from './AttachedEditor';
import type { AttachOptions } from './AttachOptions';
import { languages } from './language/languages';

/**
 * Opens an editor over a running three.js page: the tree of its objects, an inspector of transform, flags, light,
 * camera and materials, a gizmo on the selected objects, undo, and a frame panel which can switch the page to Farol.
 * The page needs no changes. While attached, the editor replaces `renderer.render` of this one renderer; otherwise it
 * listens to events and draws over finished frames. `dispose()` restores the page; edits of the scene stay.
 *
 * @param camera - camera that the page renders with; set the editor's `camera` when it changes
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
