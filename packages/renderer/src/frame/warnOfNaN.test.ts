import { Mesh, OrthographicCamera, PerspectiveCamera } from 'three';
import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { warnOfNaN } from './warnOfNaN';

const warn = vi.spyOn(console, 'warn');
beforeEach(() => warn.mockReset().mockImplementation(() => {}));
afterEach(() => warn.mockReset());

const made = (change: (camera: PerspectiveCamera) => void): PerspectiveCamera => {
  const camera = new PerspectiveCamera(50, 1, 0.1, 100);
  camera.name = 'eye';
  change(camera);
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  return camera;
};

it.each<[string, (camera: PerspectiveCamera) => void]>([
  ['fov', (camera) => (camera.fov = NaN)],
  ['aspect', (camera) => (camera.aspect = NaN)],
  ['near', (camera) => (camera.near = NaN)],
  ['far', (camera) => (camera.far = NaN)],
  ['zoom', (camera) => (camera.zoom = NaN)],
  ['position', (camera) => (camera.position.y = NaN)],
  ['rotation', (camera) => camera.quaternion.set(NaN, 0, 0, 1)],
  ['scale', (camera) => (camera.scale.x = NaN)],
])('names a camera whose %s is not a number, once, in place of what it sees', (_, change) => {
  const camera = made(change);
  warnOfNaN(camera);
  warnOfNaN(camera, new Mesh());
  expect(warn.mock.calls).toEqual([
    [expect.stringMatching(/^Farol: PerspectiveCamera "eye" has NaN in .*; set finite numbers\./)],
  ]);
});

it('names an object that a right camera sees, and no camera that is right', () => {
  for (const camera of [made(() => {}), made(({ position }) => position.set(1e12, 0, 0)), new OrthographicCamera()])
    warnOfNaN(camera);
  expect(warn).not.toHaveBeenCalled();
  const mesh = new Mesh();
  mesh.name = 'lost';
  warnOfNaN(
    made(() => {}),
    mesh,
  );
  expect(warn).toHaveBeenCalledWith(expect.stringContaining('Mesh "lost" has NaN in its matrix'));
});
