import { Box3, Vector3 } from 'three';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { EditorCamera } from './EditorCamera';
import { PointerControls } from './PointerControls';

beforeEach(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true }));
  vi.stubGlobal('window', new EventTarget());
  vi.stubGlobal('DOMRect', Object);
});
afterEach(() => {
  vi.unstubAllGlobals();
});

function makeCamera(): EditorCamera {
  const canvas = Object.assign(new EventTarget(), {
    style: {},
    setAttribute() {},
    removeAttribute() {},
    ownerDocument: new EventTarget(),
    getBoundingClientRect: () => ({ left: 0, top: 0, width: 300, height: 200 }),
  });
  return new EditorCamera(canvas as unknown as HTMLCanvasElement);
}

const moves: Readonly<Record<string, (camera: EditorCamera) => void>> = {
  shows: (camera) => camera.show({ position: [4, 3, -2], target: [1, 0, 1], fov: 0.8, orthographic: false }),
  'shows from above': (camera) =>
    camera.show({ position: [1, 9, 1], target: [1, 0, 1], fov: 0.8, orthographic: true }, false),
  'focuses in a wide view': (camera) => camera.focus(new Box3(new Vector3(-1, 0, 2), new Vector3(3, 5, 4))),
  'focuses in a narrow view': (camera) => {
    camera.resize(200, 600);
    camera.focus(new Box3(new Vector3(-1, 0, 2), new Vector3(3, 5, 4)));
  },
  'looks from the right': (camera) => camera.lookFrom(new Vector3(1, 0, 0), true),
  'looks from below': (camera) => camera.lookFrom(new Vector3(0, -1, 0)),
  orbits: (camera) => camera.orbit(0.4, -0.3),
};

function stateOf(camera: EditorCamera): number[] {
  const { pose, target, distance, height, perspective } = camera;
  perspective.updateMatrixWorld();
  return [
    ...[...pose.position, ...pose.target, pose.fov, Number(pose.orthographic), distance, height],
    ...[...target.toArray(), ...perspective.matrixWorld.elements, ...camera.camera.projectionMatrix.elements],
  ];
}

const difference = (got: number[], wanted: number[]): number =>
  Math.max(...got.map((each, i) => Math.abs(each - wanted[i])));

describe('a camera whose controls are fetched late', () => {
  for (const [name, move] of Object.entries(moves)) {
    it(`${name} as it does with controls, and keeps the view when they come`, () => {
      const [early, late] = [makeCamera(), makeCamera()];
      early.control(PointerControls);
      for (const camera of [early, late]) {
        camera.resize(300, 200);
        camera.show({ position: [5, 4, 7], target: [0, 1, 0], fov: 0.9, orthographic: false }, false);
        move(camera);
      }
      early.update(1);
      expect(difference(stateOf(late), stateOf(early))).toBeLessThan(1e-4);
      const before = stateOf(late);
      late.control(PointerControls);
      expect(difference(stateOf(late), before)).toBeLessThan(1e-4);
      late.update(1);
      expect(difference(stateOf(late), before)).toBeLessThan(1e-4);
    });
  }

  it('has a whole box in a narrow view: the sphere round it lies within the narrower field of view', () => {
    const camera = makeCamera();
    camera.resize(200, 600);
    camera.focus(new Box3(new Vector3(-1, -1, -1), new Vector3(1, 1, 1)));
    const { fov, aspect } = camera.perspective;
    const across = Math.atan(Math.tan((fov * Math.PI) / 360) * aspect);
    expect(camera.distance * Math.sin(across)).toBeCloseTo(1.15 * Math.sqrt(3));
  });

  it('is enabled for controls that come later, unless it was switched off meanwhile', () => {
    const camera = makeCamera();
    camera.active = true;
    expect(camera.enabled).toBe(true);
    camera.enabled = false;
    camera.control(PointerControls);
    expect(camera.enabled).toBe(false);
    camera.enabled = true;
    expect(camera.enabled).toBe(true);
  });
});
