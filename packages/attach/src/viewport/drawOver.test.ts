import {
  ACESFilmicToneMapping,
  NoToneMapping,
  PerspectiveCamera,
  Plane,
  Scene,
  Vector4,
  type WebGLRenderer,
} from 'three';
import { expect, it } from 'vitest';
import { Session } from '../model/Session';
import { drawOver } from './drawOver';

/** A renderer in the state of a page's own pass: target, viewport and switches are the page's. */
function busyRenderer() {
  const state = {
    target: { isTarget: true } as object | null,
    ...{ face: 3, level: 2, scissorTest: true },
    viewport: new Vector4(10, 20, 30, 40),
  };
  const webgl = {
    ...{ autoClear: true, toneMapping: ACESFilmicToneMapping, clippingPlanes: [new Plane()] },
    info: { autoReset: true, render: { frame: 7, calls: 5, triangles: 400, points: 3, lines: 2 } },
    domElement: { width: 800, height: 400 },
    getPixelRatio: () => 2,
    getViewport: (out: Vector4) => out.copy(state.viewport),
    setViewport: (x: number | Vector4, y = 0, z = 0, w = 0) =>
      typeof x === 'number' ? state.viewport.set(x, y, z, w) : state.viewport.copy(x),
    getRenderTarget: () => state.target,
    getActiveCubeFace: () => state.face,
    getActiveMipmapLevel: () => state.level,
    setRenderTarget: (target: object | null, face = 0, level = 0) => void Object.assign(state, { target, face, level }),
    getScissorTest: () => state.scissorTest,
    setScissorTest: (scissorTest: boolean) => void Object.assign(state, { scissorTest }),
  };
  const seen = () => {
    const { autoClear, toneMapping, clippingPlanes, info } = webgl;
    const { target, face, level, scissorTest, viewport } = state;
    return {
      ...{ autoClear, toneMapping, planes: [...clippingPlanes], info: structuredClone(info) },
      ...{ target, face, level, scissorTest, viewport: viewport.toArray() },
    };
  };
  return { webgl, seen };
}

it.each([false, true])(
  'the page finds its renderer, with its figures, as it was; where drawing throws: %s',
  (throws) => {
    const { webgl, seen } = busyRenderer();
    const before = seen();
    const planes = webgl.clippingPlanes;
    const session = new Session(new Scene(), new PerspectiveCamera(), webgl as unknown as WebGLRenderer);
    let during: ReturnType<typeof seen> | null = null;
    const draw = (): void =>
      drawOver(
        session,
        () => {
          during = seen();
          Object.assign(webgl.info.render, { frame: 8, calls: 1, triangles: 2, points: 4, lines: 9 });
          if (throws) throw new Error('lost');
        },
        new Scene(),
      );
    if (throws) expect(draw).toThrow('lost');
    else draw();
    expect(during).toMatchObject({
      ...{ autoClear: false, toneMapping: NoToneMapping, planes: [], target: null, scissorTest: false },
      viewport: [0, 0, 400, 200],
    });
    expect(during!).toHaveProperty('info.autoReset', false);
    expect(seen()).toEqual(before);
    expect(webgl.clippingPlanes).toBe(planes);
  },
);
