import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { App } from './App';

const { sizes, drawn } = vi.hoisted(() => ({ sizes: [] as number[][], drawn: [] as unknown[] }));

vi.mock('three', async (original) => ({
  ...(await original<typeof import('three')>()),
  WebGLRenderer: class {
    readonly domElement = Object.assign(new EventTarget(), { style: {}, remove: () => {} });
    readonly shadowMap = {};
    setSize(...size: number[]): void {
      sizes.push(size);
    }
    clear(): void {}
    dispose(): void {}
  },
}));
vi.mock('@farol/renderer', async (original) => ({
  ...(await original<typeof import('@farol/renderer')>()),
  FarolRenderer: class {
    readonly microshaders = null;
    readonly effects = [];
    readonly techniques = {};
    addEventListener(): void {}
    removeEventListener(): void {}
    readonly info = { technique: '', passes: [] };
    render(): void {
      drawn.push(sizes.at(-1));
    }
    dispose(): void {}
  },
}));

/** ResizeObservers of elements that the test resizes. */
const watches = new Set<{ target: Element | null; run: () => void }>();

class FakeResizeObserver {
  private readonly watch: { target: Element | null; run: () => void };
  constructor(run: () => void) {
    this.watch = { target: null, run };
  }
  observe(target: Element): void {
    this.watch.target = target;
    watches.add(this.watch);
  }
  disconnect(): void {
    watches.delete(this.watch);
  }
}

const parent = { clientWidth: 320, clientHeight: 180, append: () => {} };
const grow = (width: number, height: number): void => {
  Object.assign(parent, { clientWidth: width, clientHeight: height });
  for (const { target, run } of watches) if (target === (parent as unknown)) run();
};

beforeEach(() => {
  vi.stubGlobal('ResizeObserver', FakeResizeObserver);
  vi.stubGlobal('cancelAnimationFrame', () => {});
  sizes.length = drawn.length = 0;
  watches.clear();
  grow(320, 180);
});
afterEach(() => vi.unstubAllGlobals());

function make(): App {
  const scene = new Scene();
  const eye = new GameObject('Eye');
  eye.addComponent('Camera');
  scene.add(eye);
  return new App({ parent: parent as unknown as HTMLElement, keys: null, scene });
}

test('an app has the size of its parent, and follows it, drawing each size at once', () => {
  const app = make();
  expect(sizes).toEqual([[320, 180]]);
  grow(320, 180);
  expect(sizes).toHaveLength(1);
  grow(640, 200);
  expect(sizes.at(-1)).toEqual([640, 200]);
  expect(drawn).toEqual([[640, 200]]);
  expect(app.scene.activeCamera!.three).toMatchObject({ aspect: 3.2 });
  grow(0, 0);
  expect(sizes.at(-1)).toEqual([1, 1]);
  app.dispose();
  expect(watches.size).toBe(0);
});

test('a size of its own counts from then on', () => {
  const app = make();
  app.resize(100, 50);
  grow(640, 200);
  expect(sizes.at(-1)).toEqual([100, 50]);
  app.dispose();
});
