import readme from '../../README.md?raw';
import { describe, expect, it } from 'vitest';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';
import { csvColumns, runCSV } from './runCSV';
import { runMarkdown } from './runMarkdown';
import { testRow, testRun } from './testing/testRun';

/** Reads CSV by RFC 4180, independently of the code that writes it. */
function readCSV(csv: string): string[][] {
  const rows: string[][] = [];
  let cells: string[] = [];
  const cell = /(?:"((?:[^"]|"")*)"|([^",\r\n]*))(,|\r\n)/gy;
  for (let match = cell.exec(csv); match; match = cell.exec(csv)) {
    cells.push(match[1] === undefined ? match[2] : match[1].replaceAll('""', '"'));
    if (match[3] === ',') continue;
    rows.push(cells);
    cells = [];
  }
  return rows;
}

describe('runCSV', () => {
  it('has a row for each case and competitor, with a heading for each cell', () => {
    const [heading, ...rows] = readCSV(runCSV(testRun()));
    expect(heading).toEqual(csvColumns.map(({ name }) => name));
    expect(rows).toHaveLength(6);
    const record = Object.fromEntries(heading.map((name, i) => [name, rows[3][i]]));
    expect(record).toMatchObject({
      ...{ run: '2026-11-22-k3x9', device: 'ANGLE (Test, "GPU", Vulkan)', series: 'planes-lights', axis: 'lights' },
      ...{ value: '100', scene: 'benchmarkLights', parameters: 'n=1', lights: '100', width_px: '1280' },
      ...{ competitor: 'deferred', frame_median_ms: '4', frame_p10_ms: '3.6', gpu_median_ms: '2', psnr_db: '51.5' },
      ...{ draws: '100', dropped_lights: '0', problem: '' },
    });
  });

  it('has the columns that the README says, in their order', () => {
    const rows = [...readme.matchAll(/^\| `(\w+)` +\| (.*?) +\|$/gm)].map(([, name, meaning]) => [name, meaning]);
    expect(rows).toEqual(csvColumns.map(({ name, meaning }) => [name, meaning]));
  });

  it('quotes commas, quotes and line ends, and takes the meaning of a formula from a text', () => {
    const problem = '=HYPERLINK("http://x","a,\r\nb")';
    const row = { ...testRow('forward', 'planes-lights', 0, 1), problem, frame: null, likeness: null };
    const [heading, cells] = readCSV(runCSV(testRun({ rows: [row] })));
    expect(cells[heading.indexOf('problem')]).toBe(`'${problem}`);
    expect(cells[heading.indexOf('frame_median_ms')]).toBe('');
    expect(cells[heading.indexOf('psnr_db')]).toBe('');
  });

  it.each(['=', '+', '-', '@', '\t', '\r'])(
    'puts an apostrophe before a text that begins with %j, and before no other',
    (first) => {
      const text = (problem: string): string => {
        const row = { ...testRow('forward', 'planes-lights', 0, 1), problem };
        const [heading, cells] = readCSV(runCSV(testRun({ rows: [row] })));
        return cells[heading.indexOf('problem')];
      };
      expect(text(`${first}1+1`)).toBe(`'${first}1+1`);
      expect(text(`1${first}1`)).toBe(`1${first}1`);
    },
  );

  it('tells an equal picture from one without a figure', () => {
    const likeness = { reference: 'forward', psnr: null, thumbnail: '' };
    const row = { ...testRow('forward', 'planes-lights', 0, 1), likeness };
    const [heading, cells] = readCSV(runCSV(testRun({ rows: [row] })));
    expect(cells[heading.indexOf('psnr_db')]).toBe('inf');
  });
});

describe('kinds of lights and shadings', () => {
  const { series } = planOf(presets.matter.configuration);
  const plan = { ...testRun().plan, series: series.slice(3), competitors: ['forward'] };
  const rows = [testRow('forward', 'sponza-kind-2', 1, 3), testRow('forward', 'sponza-shading', 1, 4)];
  const run = testRun({ plan, rows });

  it('are columns of the CSV', () => {
    const [heading, ...cells] = readCSV(runCSV(run));
    const values = cells.map((row) =>
      ['light_kind', 'light_range_m', 'shading', 'axis'].map((name) => row[heading.indexOf(name)]),
    );
    expect(values).toEqual([
      ['rectangles', '2', 'own', 'kind'],
      ['points', '', 'gouraud', 'shading'],
    ]);
  });

  it('are names in Markdown', () => {
    const markdown = runMarkdown(run);
    expect(markdown).toContain('## Atrium (reach 2 m) over kind of lights, 1000 lights');
    expect(markdown).toMatch(/\| Kind of lights \| Farol: forward \|\n.*\n.*\n\| rectangles \| 3 \|/);
    expect(markdown).toContain('| Gouraud shading | 4 |');
  });
});

describe('runMarkdown', () => {
  it('has the tables of the thesis: a row a case, a column a competitor, the fastest in bold', () => {
    const markdown = runMarkdown(testRun());
    expect(markdown).toMatch(/^# Kitchen laptop\n/);
    expect(markdown).toContain('| N × N planes | M × M lights | Farol: forward | Farol: deferred |');
    expect(markdown).toContain('| 1 | 10 | 20 | **4** |');
    // frames per second
    expect(markdown).toContain('| 1 | 10 | 50 | 250 |');
    expect(markdown).toContain('| 640 × 360 | 8 | **3** |');
    expect(markdown).toContain('- Farol: 0.1.0 (922d2a6); three 0.187.0');
    // each row of a table has as many cells as its heading
    for (const table of markdown.split('\n\n').filter((block) => block.startsWith('|'))) {
      const widths = table
        .trim()
        .split('\n')
        .map((line) => line.split('|').length);
      expect(new Set(widths).size).toBe(1);
    }
  });

  it('says problems, warnings and lights that are left out, without their markup', () => {
    const row = { ...testRow('forward', 'planes-lights', 1, 9), problem: 'a | b <img src=x>', dropped: 36 };
    const run = testRun({ rows: [row], complete: false });
    run.surroundings.warnings.push('A software rasteriser drew.');
    const markdown = runMarkdown(run);
    expect(markdown).toContain('- Farol: forward, 100 lights: a \\| b \\<img src=x\\>');
    expect(markdown).toContain('- Farol: forward, 100 lights: 36 lights are left out.');
    expect(markdown).toContain('ended before every case was measured');
    expect(markdown).toMatch(/## Warnings\n\n- A software rasteriser drew\./);
    expect(markdown).toMatch(/## Atrium over pixels, 20 lights\n\nNothing was measured\./);
  });
});
