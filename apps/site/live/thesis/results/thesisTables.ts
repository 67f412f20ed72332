/** A row of the thesis's tables of 4.2.2: counts of the scene, and frames a second as they stand there; null for none. */
export interface ThesisRow {
  /** Number of planes along a side of the grid; missing in scenes without planes. */
  readonly n?: number;
  /** Number of lights: along a side of the grid where there are planes, else of the whole scene. */
  readonly m: number;
  readonly forward: string | null;
  readonly deferred: string | null;
}

export type ThesisTable = 'planes' | 'sponza' | 'temple';

/** Measured in 2015; the machine is not named (thesis 4.2.2). */
export const thesisTables: Readonly<Record<ThesisTable, readonly ThesisRow[]>> = {
  planes: [
    { n: 1, m: 1, forward: '60', deferred: '25-30' },
    { n: 1, m: 2, forward: '60', deferred: '25-29' },
    { n: 1, m: 5, forward: '60', deferred: '23-27' },
    { n: 1, m: 10, forward: '17-20', deferred: '20-24' },
    { n: 1, m: 15, forward: '4-8', deferred: '19-20' },
    { n: 2, m: 2, forward: '60', deferred: '29-33' },
    { n: 5, m: 5, forward: '26-29', deferred: '25-30' },
    { n: 10, m: 10, forward: null, deferred: '16-20' },
    { n: 15, m: 15, forward: null, deferred: '11-13' },
  ],
  sponza: [
    { m: 10, forward: '9-10', deferred: '23-28' },
    { m: 20, forward: '6-8', deferred: '18-21' },
    { m: 50, forward: null, deferred: '15-18' },
    { m: 100, forward: null, deferred: '9-10' },
    { m: 200, forward: null, deferred: '6-7' },
    { m: 500, forward: null, deferred: null },
  ],
  temple: [
    { m: 10, forward: '23-24', deferred: '30-35' },
    { m: 20, forward: '13-16', deferred: '29-33' },
    { m: 50, forward: '7-11', deferred: '27-30' },
    { m: 100, forward: '4-8', deferred: '23-27' },
    { m: 200, forward: null, deferred: '19-22' },
    { m: 500, forward: null, deferred: '11-14' },
  ],
};
