import { GameObject, ObjectRenderer } from '@farol/engine';
import { Vector3 } from 'three';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { EditorDocument } from '../model/EditorDocument';
import { EditorCamera } from './EditorCamera';
import { PictureCamera } from './PictureCamera';

beforeEach(() => void vi.stubGlobal('matchMedia', () => ({ matches: true })));
afterEach(() => void vi.unstubAllGlobals());

it('frames an object where it is, before a frame has drawn it there', () => {
  const document = new EditorDocument();
  const canvas = new EventTarget() as HTMLCanvasElement;
  const editorCamera = new EditorCamera(canvas);
  const camera = new PictureCamera(document, editorCamera, canvas, () => {});
  const group = new GameObject('Group');
  const sphere = new GameObject('Sphere');
  sphere.addComponent(ObjectRenderer, {});
  group.transform.position = [5, 0, 0];
  sphere.transform.position = [0, 1, 2];
  document.scene.add(group);
  group.add(sphere);
  document.selection.set([sphere.id]);
  camera.focus();
  expect(editorCamera.target).toEqual(new Vector3(5, 1, 2));
});
