import { expect, it, vi } from 'vitest';
import { PaneDrawing, type PaneSurface } from './PaneDrawing';

it('draws grid, icons and handles over the scene, but not while it is played as its players see it', () => {
  const render = vi.fn<() => void>();
  const update = vi.fn<(camera: unknown, isHidden: boolean) => void>();
  const main = { rectangle: { x: 0, y: 0, width: 4, height: 3 }, shading: 'lit' };
  const none = { get: () => null, part: null };
  const surface = {
    ...{ view: 'final', painter: null, lookThrough: null, isPlayed: false },
    document: { scene: {} },
    panes: { list: [main], active: main, main },
    webgl: { getPixelRatio: () => 1 },
    farol: { technique: 'auto', techniques: {}, view: 'final', info: { view: null } },
    picture: { draw() {} },
    gizmo: { update, isDragging: false },
    helpers: { render },
    stamps: { draw: (_scene: object, draw: () => void) => draw() },
    parts: { physics: none, lightHandles: none, particles: none },
    cameraOf: () => null,
    raysOf: () => null,
  };
  const drawing = new PaneDrawing(surface as unknown as PaneSurface);
  drawing.drawAll(4, 3);
  expect(render).toHaveBeenCalledTimes(1);
  surface.isPlayed = true;
  drawing.drawAll(4, 3);
  expect(render).toHaveBeenCalledTimes(1);
  expect(update.mock.calls.map(([, isHidden]) => isHidden)).toEqual([false, true]);
});
