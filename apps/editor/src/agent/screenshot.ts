import { Camera as CameraComponent, type GameObject } from '@farol/engine';
import type { Content, ToolInput } from '@farol/mcp/tools';
import { type Camera, PerspectiveCamera, Vector3 } from 'three';
import type { EditorApi } from '../api/EditorApi';
import { findObject } from './findObjects';

/** Longest wait for the files and code that the picture needs (ms). */
const PATIENCE = 10_000;

/** A three camera to draw with, and the scene's Camera that it belongs to; null for the editor's own. */
interface Eye {
  readonly camera: Camera;
  readonly component: CameraComponent | null;
}

function eyeOf(editor: EditorApi, { camera: reference, from, to, fov = 50 }: ToolInput<'screenshot'>): Eye {
  const { viewport, document } = editor;
  const { width, height } = viewport.size;
  if (reference !== undefined) {
    const object: GameObject = findObject(document.scene, reference);
    const component = object.getComponent(CameraComponent);
    if (!component) throw new Error(`“${object.name}” has no Camera: name an object with one, or give from and to.`);
    component.setViewport(width, height);
    return { camera: component.three, component };
  }
  if (!from && !to) return { camera: viewport.cameraOf(viewport.panes.main), component: viewport.lookThrough };
  if (!from || !to) throw new Error('Give both from and to: points (m) to look from and at.');
  const camera = new PerspectiveCamera(fov, width / height, 0.05, 2000);
  camera.position.fromArray(from);
  camera.lookAt(new Vector3().fromArray(to));
  camera.updateMatrixWorld();
  return { camera, component: null };
}

/** A picture of the scene without the editor's marks. The user's viewport stays as it was. */
export async function takeScreenshot(editor: EditorApi, input: ToolInput<'screenshot'>): Promise<Content[]> {
  const { viewport, document: edited } = editor;
  const { canvas, picture } = viewport;
  if (!canvas.isConnected || canvas.width === 0 || canvas.height === 0)
    throw new Error('The picture is not shown: ask the user to open the panel Viewport.');
  if (viewport.isQuad) throw new Error('Four views are shown: run_action view.quad shows one.');
  // waits for files of the scene and for late code, at most `PATIENCE`
  await Promise.race([picture.ready, new Promise((resolve) => setTimeout(resolve, PATIENCE))]);
  const { camera, component } = eyeOf(editor, input);
  const width = Math.min(input.width ?? 960, canvas.width);
  const height = Math.round((width * canvas.height) / canvas.width);
  const small = Object.assign(document.createElement('canvas'), { width, height });
  const context = small.getContext('2d');
  if (!context) throw new Error('This browser cannot make a picture of a canvas.');
  context.imageSmoothingQuality = 'high';
  picture.follow(edited.scene);
  picture.draw(edited.scene, camera, component);
  // copied in the same task: the browser clears the canvas after showing the frame
  context.drawImage(canvas, 0, 0, width, height);
  viewport.invalidate();
  const data = small.toDataURL('image/jpeg', 0.9);
  const isSmall = width < (input.width ?? 0);
  return [
    { type: 'image', data: data.slice(data.indexOf(',') + 1), mimeType: 'image/jpeg' },
    {
      type: 'text',
      text: `${width} × ${height} pixels, drawn by ${viewport.farol.info.technique}${isSmall ? '; the viewport is no wider' : ''}.`,
    },
  ];
}
