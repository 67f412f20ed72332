import { ArrayCamera, PerspectiveCamera, Vector4, WebGLRenderTarget, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { renderArray } from './renderArray';

/** A camera for a rectangle of the target (pixels). */
const cameraAt = (...viewport: [number, number, number, number]): PerspectiveCamera =>
  Object.assign(new PerspectiveCamera(), { viewport: new Vector4(...viewport) });

it.each([true, false])('each camera stays within its viewport and the scissor of the host; scissor test %s', (test) => {
  const target = new WebGLRenderTarget(100, 50);
  target.scissor.set(10, 5, 70, 30);
  target.scissorTest = test;
  const webgl = {
    getRenderTarget: () => target,
    setRenderTarget: () => {},
    getPixelRatio: () => 1,
    getActiveCubeFace: () => 0,
    getActiveMipmapLevel: () => 0,
  } as unknown as WebGLRenderer;
  const drawn: unknown[] = [];
  renderArray(webgl, new ArrayCamera([cameraAt(0, 0, 50, 50), cameraAt(50, 0, 50, 50)]), () =>
    drawn.push([target.viewport.toArray(), target.scissor.toArray(), target.scissorTest]),
  );
  expect(drawn).toEqual([
    [[0, 0, 50, 50], [10, 5, 70, 30], test],
    [[50, 0, 50, 50], test ? [50, 5, 30, 30] : [50, 0, 50, 50], true],
  ]);
  expect([target.viewport.toArray(), target.scissor.toArray(), target.scissorTest]).toEqual([
    [0, 0, 100, 50],
    [10, 5, 70, 30],
    test,
  ]);
});
