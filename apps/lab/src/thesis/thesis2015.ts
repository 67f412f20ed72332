/** Lowest and highest frame rate of the thesis (Hz); null when its counter failed. */
export type Frames = readonly [low: number, high: number] | null;

export interface ThesisRow {
  /** Table of the thesis. 'planes': N × N planes under M × M lights; others: a mesh under N lights. */
  readonly table: 'planes' | 'sponza' | 'temple';
  /** Number of planes, N × N; 0 for the meshes. */
  readonly planes: number;
  readonly lights: number;
  readonly forward: Frames;
  readonly deferred: Frames;
}

const planes = (n: number, m: number, forward: Frames, deferred: Frames): ThesisRow => ({
  ...{ table: 'planes', planes: n * n, lights: m * m, forward, deferred },
});
const sponza = (lights: number, forward: Frames, deferred: Frames): ThesisRow => ({
  ...{ table: 'sponza', planes: 0, lights, forward, deferred },
});
const temple = (lights: number, forward: Frames, deferred: Frames): ThesisRow => ({
  ...{ table: 'temple', planes: 0, lights, forward, deferred },
});

/** The three tables of section 4.2.2 of the thesis (2015), in frames per second; browsers limited it to 60. */
export const thesis2015: readonly ThesisRow[] = [
  planes(1, 1, [60, 60], [25, 30]),
  planes(1, 2, [60, 60], [25, 29]),
  planes(1, 5, [60, 60], [23, 27]),
  planes(1, 10, [17, 20], [20, 24]),
  planes(1, 15, [4, 8], [19, 20]),
  planes(2, 2, [60, 60], [29, 33]),
  planes(5, 5, [26, 29], [25, 30]),
  planes(10, 10, null, [16, 20]),
  planes(15, 15, null, [11, 13]),
  sponza(10, [9, 10], [23, 28]),
  sponza(20, [6, 8], [18, 21]),
  sponza(50, null, [15, 18]),
  sponza(100, null, [9, 10]),
  sponza(200, null, [6, 7]),
  sponza(500, null, null),
  temple(10, [23, 24], [30, 35]),
  temple(20, [13, 16], [29, 33]),
  temple(50, [7, 11], [27, 30]),
  temple(100, [4, 8], [23, 27]),
  temple(200, null, [19, 22]),
  temple(500, null, [11, 14]),
];
