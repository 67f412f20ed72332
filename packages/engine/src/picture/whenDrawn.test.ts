import type { FarolEvents, FarolRenderer } from '@farol/renderer';
import { EventDispatcher, NoToneMapping, PCFShadowMap } from 'three';
import { beforeEach, expect, it, vi } from 'vitest';
import { LateCode } from '../base/LateCode';
import { Scene } from '../core/Scene';
import { PictureRenderer } from './PictureRenderer';

/** A renderer that draws nothing. */
const makeFarol = () =>
  Object.assign(new EventDispatcher<FarolEvents>(), {
    webgl: {
      toneMapping: NoToneMapping,
      shadowMap: { enabled: true, type: PCFShadowMap },
      getRenderTarget: () => null,
    },
    view: 'final',
    technique: 'auto',
    effects: [],
    techniques: {},
    info: { technique: '', passes: [] },
    ready: Promise.resolve(),
    render: () => {},
  });

/** Waits until all settled promises have called their handlers. */
async function settle(): Promise<void> {
  for (let turn = 0; turn < 3; turn++) await new Promise((resolve) => setImmediate(resolve));
}

let farol: ReturnType<typeof makeFarol>;
let scene: Scene;
let redraw: ReturnType<typeof vi.fn<() => void>>;
let picture: PictureRenderer;
beforeEach(async () => {
  await import('./whenDrawn'); // loaded beforehand, since it would delay the first test
  farol = makeFarol();
  scene = new Scene();
  redraw = vi.fn<() => void>();
  picture = new PictureRenderer(farol as unknown as FarolRenderer, { redraw });
});

const draw = (): void => picture.render(scene, {} as never);

/** Records the state of `ready`. */
function wait(): { state: string } {
  const seen = { state: 'waits' };
  picture.ready.then(
    () => (seen.state = 'ready'),
    (error: Error) => (seen.state = error.message),
  );
  return seen;
}

it('asks for a frame, and waits for it', async () => {
  const seen = wait();
  await settle();
  expect([seen.state, redraw.mock.calls.length]).toEqual(['waits', 1]);
  draw();
  await settle();
  expect([seen.state, redraw.mock.calls.length]).toEqual(['ready', 1]);
});

it('waits for assets, and for a frame with them', async () => {
  draw();
  let come!: (bytes: ArrayBuffer) => void;
  const bytes = new Promise<ArrayBuffer>((resolve) => (come = resolve));
  scene.assets.registerFile('lamp.ies', { arrayBuffer: () => bytes } as Blob);
  scene.assets.load('lamp.ies').catch(() => {});
  const seen = wait();
  await settle();
  expect([seen.state, redraw.mock.calls.length]).toEqual(['waits', 0]);
  // a damaged profile is an error of the library; the light is drawn without it
  come(new ArrayBuffer(8));
  await scene.assets.settled();
  await settle();
  expect([seen.state, redraw.mock.calls.length]).toEqual(['waits', 1]);
  draw();
  await settle();
  expect(seen.state).toBe('ready');
});

it('waits for late code, and is rejected with the mend when it cannot be fetched', async () => {
  draw();
  let fail!: () => void;
  const late = new LateCode(
    () => new Promise((_, reject) => (fail = reject)),
    'The code of lamps could not be fetched: see that the network is there, and add one again.',
  );
  late.load().catch(() => {});
  const seen = wait();
  await settle();
  expect(seen.state).toBe('waits');
  fail();
  await settle();
  expect(seen.state).toBe('The code of lamps could not be fetched: see that the network is there, and add one again.');
  expect(LateCode.fetching.size).toBe(0);
});

it('waits for the renderer, and once more when that asks to be drawn again', async () => {
  let come!: () => void;
  farol.ready = new Promise((resolve) => (come = resolve));
  draw();
  const seen = wait();
  await settle();
  draw();
  await settle();
  expect(seen.state).toBe('waits');
  farol.dispatchEvent({ type: 'redraw' });
  expect(redraw).toHaveBeenCalledTimes(2);
  come();
  await settle();
  expect(seen.state).toBe('waits');
  draw();
  await settle();
  expect(seen.state).toBe('ready');
});

it('waits for all frames that TAA gathers', async () => {
  vi.spyOn(picture.effects, 'frames', 'get').mockReturnValue(3);
  const seen = wait();
  for (let frame = 1; frame <= 3; frame++) {
    await settle();
    expect([seen.state, redraw.mock.calls.length]).toEqual(['waits', frame]);
    draw();
  }
  await settle();
  expect(seen.state).toBe('ready');
});

it('is rejected when the picture is disposed, also before', async () => {
  vi.spyOn(picture.effects, 'dispose').mockImplementation(() => {});
  const seen = wait();
  await settle();
  picture.dispose();
  await settle();
  expect(seen.state).toMatch(/disposed before it was ready/);
  const asked = wait();
  await settle();
  expect(asked.state).toMatch(/disposed/);
});
