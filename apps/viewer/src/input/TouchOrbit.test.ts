import { KeyController, MouseController } from '@farol/engine';
import { PerspectiveCamera, Scene } from 'three';
import { afterEach, expect, it, vi } from 'vitest';
import type { Viewer } from '../Viewer';
import { TouchOrbit } from './TouchOrbit';

afterEach(() => {
  vi.unstubAllGlobals();
});

it('a touch takes the camera from the mouse, and the next press of the mouse gives it back', () => {
  vi.stubGlobal('window', new EventTarget());
  const page = new EventTarget();
  const canvas = Object.assign(new EventTarget(), {
    ...{ style: {}, clientWidth: 100, clientHeight: 100, ownerDocument: page, getRootNode: () => page },
    setPointerCapture: () => {},
    releasePointerCapture: () => {},
  });
  const mouse = { enabled: true };
  const keys = { enabled: true };
  const three = new PerspectiveCamera();
  const gameObject = {
    object3D: three,
    getComponent: (type: object) => (type === MouseController ? mouse : type === KeyController ? keys : null),
  };
  const activeCamera = { gameObject, three };
  const viewer = { app: { canvas, scene: { activeCamera } }, scene: new Scene(), redraw: () => {} };
  new TouchOrbit(viewer as unknown as Viewer);
  const press = (pointerType: string): boolean => {
    const event = { pointerType, pointerId: 1, button: 0, clientX: 1, clientY: 1, pageX: 1, pageY: 1 };
    canvas.dispatchEvent(Object.assign(new Event('pointerdown'), event));
    expect(keys.enabled, 'a finger that orbits does not walk').toBe(pointerType !== 'touch');
    canvas.dispatchEvent(Object.assign(new Event('pointerup'), event));
    expect(keys.enabled).toBe(true);
    return mouse.enabled;
  };
  expect(['mouse', 'touch', 'touch', 'mouse', 'pen'].map(press)).toEqual([true, false, false, true, true]);
});
