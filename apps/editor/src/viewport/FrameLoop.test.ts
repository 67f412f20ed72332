import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { FrameLoop } from './FrameLoop';

let turn: () => void;
beforeEach(() => {
  vi.stubGlobal('requestAnimationFrame', (callback: FrameRequestCallback) => {
    turn = () => callback(1);
    return 1;
  });
});
afterEach(() => vi.unstubAllGlobals());

const makeLoop = (frames: () => number, draw: () => void): FrameLoop => {
  const loop = new FrameLoop({ advance: () => false, draw, frames, failed: () => {}, rest: () => {} });
  loop.pending = 0;
  loop.start();
  return loop;
};
const drawnIn = (turns: number, draw: ReturnType<typeof vi.fn>): number => {
  draw.mockClear();
  for (let i = 0; i < turns; i++) turn();
  return draw.mock.calls.length;
};

it('draws as many frames as were asked for, fewer once a frame has told that they do', () => {
  let frames = 64;
  const draw = vi.fn<() => void>();
  const loop = makeLoop(() => frames, draw);
  loop.ask(64);
  expect(drawnIn(100, draw)).toBe(64);
  draw.mockImplementation(() => (frames = 16));
  loop.ask(64);
  expect(drawnIn(100, draw)).toBe(16);
});

it('keeps a request that comes while a frame is drawn', () => {
  const draw = vi.fn<() => void>();
  const loop = makeLoop(() => 1, draw);
  draw.mockImplementationOnce(() => loop.ask(1));
  loop.ask(1);
  expect(drawnIn(10, draw)).toBe(2);
});
