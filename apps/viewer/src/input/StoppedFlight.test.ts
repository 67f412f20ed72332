import { afterEach, expect, it, vi } from 'vitest';
import type { Viewer } from '../Viewer';
import { StoppedFlight } from './StoppedFlight';

afterEach(() => {
  vi.unstubAllGlobals();
});

/** A page whose animation frames the test calls. */
function makeFlight() {
  const page = new EventTarget();
  let next: FrameRequestCallback | null = null;
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page));
  vi.stubGlobal('requestAnimationFrame', (callback: FrameRequestCallback) => {
    next = callback;
    return 1;
  });
  const redraw = vi.fn<() => void>();
  const viewer = { app: { canvas: new EventTarget(), scene: { activeCamera: null } }, state: { time: 0 }, redraw };
  new StoppedFlight(viewer as unknown as Viewer);
  const send = (type: string, values: object): boolean => page.dispatchEvent(Object.assign(new Event(type), values));
  const frame = (): void => {
    const callback = next;
    next = null;
    callback?.(0);
  };
  return { redraw, send, frame };
}

it('lets go of the keys that were held while Command was down: macOS tells of no other end', () => {
  const { redraw, send, frame } = makeFlight();
  send('keydown', { code: 'KeyW', key: 'w', metaKey: true });
  frame();
  expect(redraw).toHaveBeenCalledTimes(1);
  send('keyup', { code: 'MetaLeft', key: 'Meta' });
  frame();
  frame();
  expect(redraw).toHaveBeenCalledTimes(1);
});

it('hears nothing that is typed, also in a shadow root', () => {
  const { redraw, send, frame } = makeFlight();
  send('keydown', { code: 'KeyW', key: 'w', composedPath: () => [{ tagName: 'INPUT' }, {}] });
  frame();
  expect(redraw).not.toHaveBeenCalled();
});
