import { expect, it } from 'vitest';
import { remainingMinutes, runLine } from './benchLabWords.mjs';

const row = (competitor: string, median: number | null) => ({
  ...{ competitor, series: 'sponza-lights', index: 1, frame: median === null ? null : { median } },
  ...{ likeness: null, problem: median === null ? 'No WebGPU here.' : null },
});

it('tells a case that is over, the fastest first, and who has no figure', () => {
  const series = { label: 'Atrium over point lights', axis: 'lights', values: [10, 1000], cases: [{}, {}] };
  const rows = [row('forward', 90.4), row('three-webgpu', null), row('auto', 2.104)];
  expect(runLine(series, 1, rows)).toBe(
    'Atrium over point lights, 1,000 lights: auto 2.10, forward 90.4 ms; no figure: three-webgpu',
  );
  expect(runLine({ ...series, values: [1] }, 0, [row('stock', null)])).toBe(
    'Atrium over point lights, 1 light: nothing; no figure: stock',
  );
});

it('tells a kind of lights and a shading by their names', () => {
  const cases = [{ lightKind: 'rectangles', shading: 'flat' }];
  const series = { label: 'Atrium', values: [2], cases };
  expect(runLine({ ...series, axis: 'kind' }, 0, [row('forward', 1)])).toBe('Atrium, rectangles: forward 1 ms');
  expect(runLine({ ...series, axis: 'shading' }, 0, [row('forward', 1)])).toBe('Atrium, flat: forward 1 ms');
});

it('tells the time left in seconds, then in minutes', () => {
  expect(remainingMinutes(null)).toBe('');
  expect(remainingMinutes(200)).toBe(', 1 s left');
  expect(remainingMinutes(42_000)).toBe(', 42 s left');
  expect(remainingMinutes(600_000)).toBe(', 10 min left');
});
