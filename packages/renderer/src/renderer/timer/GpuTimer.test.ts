import { describe, expect, it } from 'vitest';
import { GpuTimer } from './GpuTimer';

const [ELAPSED, DISJOINT] = [1, 2];

/** A WebGL context whose queries get results (ms) when the test says so. */
function makeContext() {
  const answers = new Map<object, number>();
  const state = { disjoint: false, current: null as object | null, made: 0, deleted: 0 };
  const gl = {
    CURRENT_QUERY: 3,
    QUERY_RESULT_AVAILABLE: 4,
    QUERY_RESULT: 5,
    getExtension: () => ({ TIME_ELAPSED_EXT: ELAPSED, GPU_DISJOINT_EXT: DISJOINT }),
    getQuery: () => state.current,
    createQuery: () => ({ number: state.made++ }),
    deleteQuery: () => state.deleted++,
    beginQuery: (_: number, query: object) => (state.current = query),
    endQuery: () => (state.current = null),
    getParameter: () => state.disjoint,
    getQueryParameter: (query: object, name: number) => (name === 4 ? answers.has(query) : answers.get(query)! * 1e6),
  };
  const queries: object[] = [];
  const timer = new GpuTimer(gl as unknown as WebGL2RenderingContext);
  const time = (name: string) => {
    timer.begin(name);
    if (state.current !== null) queries.push(state.current);
    timer.end();
  };
  return { timer, time, state, answer: (index: number, ms: number) => answers.set(queries[index], ms) };
}

describe('GpuTimer', () => {
  it('has the time of each pass once its query is answered, in order', () => {
    const { timer, time, answer } = makeContext();
    time('g-buffer');
    time('lighting');
    expect(timer.poll()).toBe(false);
    answer(1, 5);
    // results are read in the order of the queries
    expect(timer.poll()).toBe(false);
    answer(0, 2);
    expect(timer.poll()).toBe(true);
    expect([...timer.times]).toEqual([
      ['g-buffer', 2],
      ['lighting', 5],
    ]);
  });

  it('takes no time from what was interrupted, and uses its queries again', () => {
    const { timer, time, state, answer } = makeContext();
    time('lighting');
    state.disjoint = true;
    answer(0, 9);
    expect(timer.poll()).toBe(true);
    expect(timer.times.size).toBe(0);
    time('lighting');
    expect(state.made).toBe(1);
  });

  it("keeps out of the way of the host's own query", () => {
    const { timer, state } = makeContext();
    const own = {};
    state.current = own;
    timer.begin('lighting');
    timer.end();
    expect(state.current).toBe(own);
    expect(state.made).toBe(0);
  });

  it('forgets the queries of a lost context, and deletes what it holds at the end', () => {
    const { timer, time, state } = makeContext();
    time('lighting');
    timer.restart();
    expect(timer.poll()).toBe(false);
    time('lighting');
    timer.dispose();
    expect(state.deleted).toBe(1);
  });
});
