import { GameObject, Scene } from '@farol/engine';
import { PerspectiveCamera, Vector3 } from 'three';
import { expect, it } from 'vitest';
import type { EditorApi } from '../../api/EditorApi';
import { makeShot, type Shot } from './shots';

/** An editor that looks at the origin from (0, 3, 4), with one object there. */
function makeEditor(): { editor: EditorApi; scene: Scene } {
  const scene = new Scene();
  scene.add(new GameObject('Middle'));
  const camera = new PerspectiveCamera(50, 1, 0.1, 100);
  camera.position.set(0, 3, 4);
  camera.lookAt(0, 0, 0);
  const viewport = { lookThrough: null, panes: { main: null }, cameraOf: () => camera };
  return { editor: { document: { scene, selectedObjects: [] }, viewport } as never, scene };
}

const placeAt = (shot: Shot, share: number): number[] =>
  shot(share)
    .eye.getWorldPosition(new Vector3())
    .toArray()
    .map((each) => Math.round(each * 1e6) / 1e6 + 0);

it('a path comes through the kept views in their order, one camera throughout', () => {
  const { editor, scene } = makeEditor();
  const places = [
    [0, 1, 5],
    [4, 2, 0],
    [0, 3, -5],
  ] as const;
  places.forEach((position, i) =>
    scene.views.set(9 - i, { name: '', position: [...position], target: [0, 0, 0], fov: 1, orthographic: false }),
  );
  const shot = makeShot(editor, 'path', 2, 1);
  expect([0, 0.5, 1].map((share) => placeAt(shot, share))).toEqual(places.toReversed().map((each) => [...each]));
  expect(shot(0.2).eye).toBe(shot(0.7).eye);
  expect((shot(0.3).eye as PerspectiveCamera).aspect).toBe(2);
  scene.views.set(9, null);
  scene.views.set(8, null);
  expect(() => makeShot(editor, 'path', 2, 1)).toThrow('A path needs two stored views');
});

it('a turntable goes around at one height, as far away, and ends where it began', () => {
  const { editor } = makeEditor();
  const shot = makeShot(editor, 'turntable', 1, 2);
  expect([0, 0.125, 0.25, 0.5].map((share) => placeAt(shot, share))).toEqual([
    [0, 3, 4],
    [4, 3, 0],
    [0, 3, -4],
    [0, 3, 4],
  ]);
  const ahead = shot(0.1).eye.getWorldDirection(new Vector3());
  const middle = shot(0.1).eye.getWorldPosition(new Vector3()).negate().normalize();
  expect(ahead.distanceTo(middle)).toBeLessThan(1e-6);
});

it('a camera that is gone is named before anything is drawn', () => {
  expect(() => makeShot(makeEditor().editor, 'none', 1, 1)).toThrow('The scene has no such camera any more');
});
