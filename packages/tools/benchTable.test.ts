import { describe, expect, it } from 'vitest';
import { benchTable, digits } from './benchTable.mjs';

const heading = { date: '2026-01-01', builds: ['now'], renderer: 'a device', browser: '156', rounds: 3 };
const benchCase = (over: object = {}) => ({
  ...{ scene: 'sponza', technique: 'deferred', lights: 100, size: { width: 320, height: 180 }, build: 0, query: '?' },
  ...over,
});
const summary = (over: object = {}) => ({
  ...{ gpu: { median: 2, p95: 3 }, cpu: { median: 0.5, p95: 0.75 }, frame: { median: 4, p95: 5 }, batch: null },
  ...{ firstMs: 31.25, added: { ms: 6, ratio: 1.5, programs: 0, lights: 10 }, removed: null, lights: 103, visible: 90 },
  ...{ draws: 12, triangles: 5, programs: 7, uploadBytes: 20480, stillUploadBytes: 0, targetBytes: 2.5e6 },
  ...{ technique: 'deferred', ...over },
});
const cells = (text: string, name: string) =>
  text
    .split('\n')
    .find((line) => line.includes(`| ${name}`))!
    .split(' | ')
    .map((cell) => cell.replaceAll('|', '').trim());

describe('benchTable', () => {
  it('has a row a case, each figure under its title', () => {
    const text = benchTable(heading, [{ benchCase: benchCase(), outcomes: [{ summary: summary(), error: null }] }]);
    const titles = text.split('\n').find((line) => line.startsWith('| lights'))!;
    const row = cells(text, 'deferred');
    expect(titles.split(' | ')).toHaveLength(row.length);
    expect(row.slice(0, 8)).toEqual(['100', 'deferred', '2', '3', '0.50', '0.75', '4', '5']);
    expect(row.slice(8)).toEqual(['–', '12', '7', '20.5', '2.50', '31.3', '6 ms, ×1.50, 0 pr.', '–']);
    expect(text).toContain('## sponza, 320×180');
    expect(text).toContain('a device, Chromium 156, 3 rounds');
  });

  it('compares two builds figure by figure', () => {
    const outcomes = [summary(), summary({ gpu: { median: 4, p95: 4 } })].map((summary) => ({ summary, error: null }));
    const text = benchTable({ ...heading, builds: ['now', 'v1'] }, [{ benchCase: benchCase(), outcomes }]);
    expect(cells(text, 'deferred')[2]).toBe('2 / 4 (0.50)');
    expect(text).toContain('now / v1 (ratio)');
  });

  it('shows what the other build lacks as a dash, without a ratio', () => {
    const outcomes = [{ summary: summary(), error: null }, null];
    const text = benchTable({ ...heading, builds: ['now', 'v1'] }, [{ benchCase: benchCase(), outcomes }]);
    expect(cells(text, 'deferred')[2]).toBe('2 / –');
  });

  it('makes an error a row of one line that stays in its cell', () => {
    const outcomes = [{ summary: null, error: `lost | context\n${'x'.repeat(300)}` }];
    const row = benchTable(heading, [{ benchCase: benchCase(), outcomes }])
      .split('\n')
      .find((line) => line.includes('lost'))!;
    expect(row).toContain('lost \\| context x');
    expect(row.length).toBeLessThan(300);
  });

  it('keeps what was measured before an error, with the error beside it', () => {
    const outcomes = [{ summary: summary(), error: 'not done after 60 s' }];
    const row = cells(benchTable(heading, [{ benchCase: benchCase(), outcomes }]), 'deferred');
    expect(row[1]).toContain('not done after 60 s');
    expect(row[2]).toBe('2');
  });

  it('names the technique that auto picked, and starts a table for each scene and size', () => {
    const rows = [benchCase({ technique: 'auto' }), benchCase({ scene: 'temple' })].map((benchCase) => ({
      benchCase,
      outcomes: [{ summary: summary(), error: null }],
    }));
    const text = benchTable(heading, rows);
    expect(cells(text, 'auto')[1]).toBe('auto (deferred)');
    expect(text.match(/^## /gm)).toHaveLength(2);
  });
});

it('digits gives about three of them', () => {
  expect([1234.5, 12.345, 1.2345, 0.09876, 0.0123, 7, 0].map(digits)).toEqual([
    '1235',
    '12.3',
    '1.23',
    '0.10',
    '0.012',
    '7',
    '0',
  ]);
  expect([null, undefined, Number.NaN].map(digits)).toEqual(['–', '–', '–']);
});
