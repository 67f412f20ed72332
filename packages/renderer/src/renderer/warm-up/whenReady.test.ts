import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { LastFrame } from '../LastFrame';
import { Lazy } from '../../frame/Lazy';
import { whenReady } from './whenReady';

/** The parts of a FarolRenderer that `whenReady` reads; its frames need the code of `parts`. */
class FakeRenderer {
  readonly redraw = vi.fn<() => void>();
  readonly last = new LastFrame(this.redraw);
  readonly picker = { isChanging: false };
  disposed = false;
  parts: readonly Lazy<object>[] = [];

  /** @param inside - called within the frame */
  draw(inside: () => void = () => {}): void {
    const outer = this.last.begin();
    for (const part of this.parts) part.ask();
    inside();
    this.last.end();
    Lazy.lacking = outer;
  }

  /** Records the state of a promise of `whenReady`. */
  wait(): { state: string } {
    const seen = { state: 'waits' };
    whenReady(this.last, this.picker, () => this.disposed).then(
      () => (seen.state = 'ready'),
      (error: Error) => (seen.state = error.message),
    );
    return seen;
  }
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

/** Runs pending promise callbacks, and timers without a delay. */
const settle = () => vi.advanceTimersByTimeAsync(1);

/** A part of late code, and functions that end its fetch. */
function late(name: string) {
  let come!: () => void;
  let fail!: (error: Error) => void;
  const part = new Lazy(
    name,
    () =>
      new Promise<object>((resolve, reject) => {
        come = () => resolve({});
        fail = reject;
      }),
    'nothing is drawn',
  );
  return { part, come: () => come(), fail: (error: Error) => fail(error) };
}

let farol: FakeRenderer;
beforeEach(() => {
  farol = new FakeRenderer();
});

it('waits for the first frame', async () => {
  const seen = farol.wait();
  await settle();
  expect(seen.state).toBe('waits');
  farol.draw();
  await settle();
  expect(seen.state).toBe('ready');
});

it('is fulfilled without a frame when the last one lacked nothing', async () => {
  farol.draw();
  const seen = farol.wait();
  await settle();
  expect([seen.state, farol.last.pending]).toEqual(['ready', []]);
});

it('waits for code, which is pending meanwhile, and for a frame that had it', async () => {
  const { part, come } = late('shadows');
  farol.parts = [part];
  farol.draw();
  const seen = farol.wait();
  farol.draw();
  await settle();
  expect([seen.state, farol.last.pending, farol.redraw.mock.calls.length]).toEqual(['waits', ['shadows'], 0]);
  come();
  await settle();
  expect([seen.state, farol.last.pending, farol.redraw.mock.calls.length]).toEqual(['waits', [], 1]);
  farol.draw();
  await settle();
  expect([seen.state, farol.redraw.mock.calls.length]).toEqual(['ready', 1]);
});

it('waits on when the frame with the code asks for other code', async () => {
  const [first, second] = [late('shadows'), late('views')];
  farol.parts = [first.part];
  farol.draw();
  const seen = farol.wait();
  first.come();
  await settle();
  farol.parts = [first.part, second.part];
  farol.draw();
  await settle();
  expect([seen.state, farol.last.pending]).toEqual(['waits', ['views']]);
  second.come();
  await settle();
  farol.draw();
  await settle();
  expect(seen.state).toBe('ready');
});

it('is rejected, with the part and the mend, when code cannot be fetched; one that is asked for later may be fulfilled', async () => {
  vi.spyOn(console, 'warn').mockImplementation(() => {});
  const { part, come, fail } = late('shadows');
  farol.parts = [part];
  farol.draw();
  const seen = farol.wait();
  fail(new Error('offline'));
  await settle();
  expect(seen.state).toMatch(/code of shadows cannot be fetched.*offline.*Serve the files/);
  expect(farol.last.pending).toEqual(['shadows']);
  const again = farol.wait();
  come();
  await settle();
  farol.draw();
  await settle();
  expect(again.state).toBe('ready');
});

it('waits for the next frame after the context was lost', async () => {
  farol.draw();
  farol.last.isDrawn = false;
  const seen = farol.wait();
  await settle();
  expect(seen.state).toBe('waits');
  farol.draw();
  await settle();
  expect(seen.state).toBe('ready');
});

it('is rejected when the renderer is disposed, also while code is fetched', async () => {
  farol.parts = [late('shadows').part];
  farol.draw();
  const seen = farol.wait();
  await settle();
  farol.disposed = true;
  farol.last.tell();
  await settle();
  expect(seen.state).toMatch(/disposed before it was ready/);
  const asked = farol.wait();
  await settle();
  expect(asked.state).toMatch(/disposed/);
});

it("has frames drawn until a change of technique by 'auto' is over, also by hosts that draw at once", async () => {
  farol.picker.isChanging = true;
  farol.draw();
  const frames: number[] = [];
  farol.redraw.mockImplementation(() => {
    farol.picker.isChanging = frames.push(frames.length) < 3;
    farol.draw();
  });
  const seen = farol.wait();
  await settle();
  await settle();
  expect([seen.state, frames]).toEqual(['ready', [0, 1, 2]]);
});

it('knows of each renderer alone what it lacks, also where one draws within a frame of another', async () => {
  const other = new FakeRenderer();
  const [shadows, views] = [late('shadows'), late('views')];
  farol.parts = [shadows.part];
  other.parts = [views.part];
  farol.draw(() => other.draw());
  views.part.ask();
  expect([farol.last.pending, other.last.pending, Lazy.lacking]).toEqual([['shadows'], ['views'], null]);
});
