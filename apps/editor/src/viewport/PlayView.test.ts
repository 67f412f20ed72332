import { Camera, GameObject, Scene } from '@farol/engine';
import { Quaternion, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { EditorDocument } from '../model/EditorDocument';
import { PlayView } from './PlayView';

function openScene(): { document: EditorDocument; camera: Camera; view: { lookThrough: Camera | null } } {
  const scene = new Scene();
  const parent = new GameObject('Parent');
  parent.transform.position = [1, 2, 3];
  parent.transform.rotation = [0.3, 0.5, 0];
  const object = new GameObject('Camera');
  object.transform.position = [0, 0, 5];
  parent.add(object);
  scene.add(parent);
  const document = new EditorDocument();
  document.open(scene);
  return { document, camera: object.addComponent(Camera), view: { lookThrough: null } };
}

const here = {
  position: new Vector3(-4, 1, 7),
  quaternion: new Quaternion(0.1, 0.7, -0.2, 0.4).normalize(),
  fov: 1,
  size: null,
  far: 0,
};

it('plays from where the editor looks: the camera is there until the scene stops, and nothing is history', () => {
  const { document, camera, view } = openScene();
  const playView = new PlayView(document, view);
  const before = document.serialize();
  playView.play(camera, here);
  expect(document.simulation.state).toBe('playing');
  expect(view.lookThrough).toBe(camera);
  camera.three.updateWorldMatrix(true, false);
  expect(new Vector3().setFromMatrixPosition(camera.three.matrixWorld).distanceTo(here.position)).toBeLessThan(1e-9);
  expect(camera.three.getWorldQuaternion(new Quaternion()).angleTo(here.quaternion)).toBeLessThan(1e-6);
  document.simulation.stop();
  expect(view.lookThrough).toBeNull();
  expect(camera.gameObject.object3D.position.toArray()).toEqual([0, 0, 5]);
  expect(document.serialize()).toBe(before);
  expect(document.commands.history).toEqual([]);
});

it('plays through the camera where it is, and looks afterwards through what was looked through', () => {
  const { document, camera, view } = openScene();
  const playView = new PlayView(document, view);
  view.lookThrough = camera;
  playView.play(camera, null);
  expect(camera.gameObject.object3D.position.toArray()).toEqual([0, 0, 5]);
  document.simulation.pause();
  expect(view.lookThrough).toBe(camera);
  document.simulation.stop();
  expect(view.lookThrough).toBe(camera);
  view.lookThrough = null;
  document.simulation.play();
  document.simulation.stop();
  expect(view.lookThrough, 'plain playing changes no view').toBeNull();
  playView.dispose();
});

it('shows the scene as its players see it while it plays through the camera, and is paused to be edited', () => {
  const { document, camera, view } = openScene();
  const playView = new PlayView(document, view);
  document.simulation.play();
  expect(playView.isOn, 'plain playing keeps grid, icons and handles').toBe(false);
  document.simulation.stop();
  playView.play(camera, null);
  expect(playView.isOn).toBe(true);
  document.simulation.pause();
  expect(playView.isOn).toBe(false);
  document.simulation.play();
  expect(playView.isOn).toBe(true);
  view.lookThrough = null;
  expect(playView.isOn).toBe(false);
  view.lookThrough = camera;
  document.simulation.stop();
  expect(playView.isOn).toBe(false);
});
