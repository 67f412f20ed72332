import type CameraControls from 'camera-controls';
import { afterEach, expect, it, vi } from 'vitest';
import { FlyControls } from './FlyControls';

afterEach(() => {
  vi.unstubAllGlobals();
});

it('lets go of the keys that were held while Command was down: macOS tells of no other end', () => {
  const page = new EventTarget();
  vi.stubGlobal('window', page);
  const canvas = Object.assign(new EventTarget(), { setPointerCapture() {}, focus() {} });
  const controls = {
    getPosition: () => {},
    getTarget: () => ({ sub: () => {} }),
    setLookAt: () => Promise.resolve(),
    camera: { fov: 60 },
  } as unknown as CameraControls;
  const fly = new FlyControls(
    canvas as unknown as HTMLCanvasElement,
    controls,
    () => true,
    () => false,
  );
  const send = (target: EventTarget, type: string, values: object): boolean =>
    target.dispatchEvent(Object.assign(new Event(type), values));
  send(canvas, 'pointerdown', { button: 2, pointerId: 1 });
  send(page, 'keydown', { code: 'KeyW', key: 'w', metaKey: true });
  expect(fly.update(0.1)).toBe(true);
  send(page, 'keyup', { code: 'MetaLeft', key: 'Meta' });
  expect(fly.update(0.1)).toBe(false);
  fly.dispose();
});
