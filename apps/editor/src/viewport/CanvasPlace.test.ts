import { afterEach, expect, it, vi } from 'vitest';
import { CanvasPlace } from './CanvasPlace';

afterEach(() => {
  vi.unstubAllGlobals();
});

it('has the canvas sized anew on a screen of another pixel ratio', () => {
  const query = new EventTarget();
  vi.stubGlobal('matchMedia', () => query);
  vi.stubGlobal('devicePixelRatio', 1);
  vi.stubGlobal(
    'ResizeObserver',
    class {
      observe(): void {}
      disconnect(): void {}
    },
  );
  const parent = { clientWidth: 320, clientHeight: 180, append: () => {} } as unknown as HTMLElement;
  const resized = vi.fn<() => void>();
  const place = new CanvasPlace({ parentElement: parent, remove: () => {} } as unknown as HTMLCanvasElement, resized);
  place.attach(parent);
  query.dispatchEvent(new Event('change'));
  expect(resized).toHaveBeenCalledTimes(2);
  place.dispose();
  query.dispatchEvent(new Event('change'));
  expect(resized).toHaveBeenCalledTimes(2);
});
