import { PerspectiveCamera, Scene, Vector2, Vector4, type WebGLRenderer } from 'three';
import { afterEach, expect, it, vi } from 'vitest';
import { Session } from '../model/Session';
import { drawOver } from './drawOver';
import { locate } from './locate';
import { RenderHook } from './RenderHook';

afterEach(() => {
  vi.unstubAllGlobals();
});

const whole = new Vector4(0, 0, 1, 1);

/** A canvas at (10, 20) with a picture of 200 × 100 CSS pixels, and equal borders on all sides. */
function canvas(border: number, padding: number, scale = 1): HTMLElement {
  const [width, height] = [200 + 2 * (border + padding), 100 + 2 * (border + padding)];
  vi.stubGlobal('getComputedStyle', () => {
    const side = `${padding}px`;
    return { paddingLeft: side, paddingRight: side, paddingTop: side, paddingBottom: side };
  });
  return {
    getBoundingClientRect: () => ({ left: 10, top: 20, width: width * scale, height: height * scale }),
    ...{ offsetWidth: width, offsetHeight: height, clientLeft: border, clientTop: border },
    ...{ clientWidth: width - 2 * border, clientHeight: height - 2 * border },
  } as unknown as HTMLElement;
}

const located = (element: HTMLElement, view: Vector4, clientX: number, clientY: number): number[] => {
  const at = new Vector2();
  locate(element, view, { clientX, clientY }, at);
  return at.toArray().map((each) => Math.round(each * 1e6) / 1e6);
};

it('finds the pointer in the picture, past border and padding', () => {
  expect(located(canvas(0, 0), whole, 60, 45)).toEqual([-0.5, 0.5]);
  expect(located(canvas(3, 7), whole, 70, 55)).toEqual([-0.5, 0.5]);
  expect(located(canvas(3, 7, 2), whole, 130, 90)).toEqual([-0.5, 0.5]);
});

it('finds the pointer in the part of the canvas that is drawn into', () => {
  // the upper right quarter
  const quarter = new Vector4(0.5, 0.5, 0.5, 0.5);
  expect(located(canvas(0, 0), quarter, 160, 45)).toEqual([0, 0]);
  expect(located(canvas(0, 0), quarter, 60, 95)).toEqual([-2, -2]);
});

it('the overlay is drawn where the page draws the scene by its camera', () => {
  const viewport = new Vector4(0, 0, 400, 200);
  const drawn: [string, number[]][] = [];
  const webgl = {
    domElement: { width: 800, height: 400 },
    getPixelRatio: () => 2,
    getViewport: (target: Vector4) => target.copy(viewport),
    setViewport: (x: number | Vector4, y = 0, z = 0, w = 0) =>
      typeof x === 'number' ? viewport.set(x, y, z, w) : viewport.copy(x),
    getRenderTarget: () => null,
    setRenderTarget: () => {},
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
    getScissorTest: () => false,
    setScissorTest: () => {},
    xr: { isPresenting: false },
    info: { render: {} },
    render: (scene: Scene) => void drawn.push([scene.name, viewport.toArray()]),
  } as unknown as WebGLRenderer;
  const [scene, overlay, camera] = [new Scene(), new Scene(), new PerspectiveCamera()];
  overlay.name = 'overlay';
  const session = new Session(scene, camera, webgl);
  vi.stubGlobal('queueMicrotask', () => {});
  const hook = new RenderHook(session, () => {});
  webgl.setViewport(100, 50, 200, 100);
  webgl.render(scene, camera);
  // a minimap of the page, drawn with another camera
  webgl.setViewport(0, 0, 50, 50);
  webgl.render(scene, new PerspectiveCamera());
  hook.dispose();
  expect(session.view.toArray()).toEqual([0.25, 0.25, 0.5, 0.5]);
  drawOver(session, webgl.render, overlay);
  expect(drawn.at(-1)).toEqual(['overlay', [100, 50, 200, 100]]);
  expect(viewport.toArray()).toEqual([0, 0, 50, 50]);
});
