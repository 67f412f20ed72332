import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { GpuTimer } from './GpuTimer';

const TIME_ELAPSED_EXT = 0x88bf;
const GPU_DISJOINT_EXT = 0x8fbb;

/** A context whose queries have results (ns) after being polled some times. */
function context(times: readonly number[], { disjoint = false, patience = 3 } = {}) {
  const alive = new Set<number>();
  const result = new Map<number, number>();
  let running: number | null = null;
  let measured = 0;
  let asked = 0;
  const gl = {
    QUERY_RESULT_AVAILABLE: 0x8867,
    QUERY_RESULT: 0x8866,
    getExtension: () => ({ TIME_ELAPSED_EXT, GPU_DISJOINT_EXT }),
    createQuery() {
      alive.add(alive.size);
      return alive.size - 1;
    },
    deleteQuery: (query: number) => void alive.delete(query),
    beginQuery(_target: number, query: number) {
      expect(running).toBeNull();
      running = query;
    },
    endQuery() {
      result.set(running!, times[measured++ % times.length]);
      running = null;
    },
    getQueryParameter: (query: number, name: number) => (name === 0x8867 ? ++asked > patience : result.get(query)),
    getParameter: () => disjoint,
    isContextLost: () => false,
    flush() {},
  };
  return { gl: gl as unknown as WebGL2RenderingContext, alive };
}

let now = 0;
beforeEach(() => void vi.spyOn(performance, 'now').mockImplementation(() => now));
afterEach(() => void vi.restoreAllMocks());

/** A frame that takes half a millisecond. */
const frame = (): void => void (now += 0.5);

describe('GpuTimer', () => {
  it('times each frame, and uses its queries again', async () => {
    const { gl, alive } = context([100_000, 200_000]);
    const timer = GpuTimer.of(gl)!;
    expect(await timer.time(2, frame)).toEqual([0.1, 0.2]);
    expect(await timer.time(1, frame)).toEqual([0.1]);
    expect(alive.size).toBe(2);
    timer.dispose();
    expect(alive.size).toBe(0);
  });

  it('gives none of a clock that was disturbed', async () => {
    expect(await GpuTimer.of(context([100_000], { disjoint: true }).gl)!.time(2, frame)).toEqual([]);
  });

  it('leaves out times that cannot be, as of a clock that went backwards', async () => {
    const { gl } = context([100_000, 2 ** 64 - 1]);
    expect(await GpuTimer.of(gl)!.time(4, frame)).toEqual([0.1, 0.1]);
  });

  it('is none where the device has no clock', () => {
    const gl = { getExtension: () => null } as unknown as WebGL2RenderingContext;
    expect(GpuTimer.of(gl)).toBeNull();
  });
});
