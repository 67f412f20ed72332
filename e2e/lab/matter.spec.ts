import { expect, test } from '../support/test';

interface Series {
  axis: string;
  values: number[];
  lights: number;
}

interface Row {
  competitor: string;
  series: string;
  index: number;
  problem: string | null;
  frame: { median: number } | null;
  cpu: { median: number } | null;
  likeness: { reference: string; psnr: number | null } | null;
}

interface Headless {
  configurationOf(fragment: string): { series: Series[] };
  planOf(configuration: object): { series: { name: string; label: string; cases: object[] }[] };
  run(plan: object): Promise<{ rows: Row[]; complete: boolean }>;
  files(run: object): { name: string; text: string }[];
}

test('the preset Light and matter in small: every kind of light and shading is measured, or left out in a sentence @verify', async ({
  page,
}) => {
  test.slow();
  await page.goto('./?headless');
  await page.waitForFunction(() => 'lab' in window);
  const { labels, run, text } = await page.evaluate(async () => {
    const { lab } = window as unknown as { lab: Headless };
    const fragment =
      'preset=matter&techniques=clustered-forward,deferred,stock,multipass&size=96x54&rounds=1&turn=20&longest=60000';
    const configuration = lab.configurationOf(fragment);
    // four planes and nine lights in place of the atrium and its thousands, with the kinds that the preset lacks
    const small = configuration.series.map((each) => {
      const few = { ...each, scene: 'benchmarkLights', n: 2, lights: 9 };
      if (each.axis === 'lights') return { ...few, values: [9] };
      return each.axis === 'kind' ? { ...few, values: [0, 1, 2, 3, 4, 5] } : few;
    });
    const plan = lab.planOf({ ...configuration, series: small.filter((_, i) => i !== 3) });
    const run = await lab.run(plan);
    return {
      labels: plan.series.map(({ name, label }) => `${name}: ${label}`),
      run,
      text: lab.files(run)[0].text,
    };
  });
  expect(labels).toEqual([
    'planes-lights-particles: Planes 2 × 2 (particles) over lights',
    'planes-lights-field: Planes 2 × 2 (a LightField; reach 1 m) over lights',
    'planes-kind: Planes 2 × 2 (reach 2 m) over kind of lights, 9 lights',
    'planes-shading: Planes 2 × 2 over shading, 9 lights',
  ]);
  expect(run.complete).toBe(true);
  const found = Object.fromEntries(run.rows.map((row) => [`${row.competitor} ${row.series} ${row.index}`, row]));
  const places = ['planes-lights-particles 0', 'planes-lights-field 0'].concat(
    [0, 1, 2, 3, 4, 5].map((index) => `planes-kind ${index}`),
    [0, 1, 2].map((index) => `planes-shading ${index}`),
  );
  for (const place of places) {
    for (const technique of ['clustered-forward', 'deferred']) {
      const row = found[`${technique} ${place}`];
      expect(row, `${technique} ${place}`).toMatchObject({ problem: null });
      expect(row.frame!.median, place).toBeGreaterThan(0);
      expect(row.cpu!.median, place).toBeGreaterThan(0);
      expect(row.likeness!.psnr ?? Infinity, `${technique} ${place}`).toBeGreaterThan(40);
    }
  }
  const problem = (competitor: string, place: string) => found[`${competitor} ${place}`].problem;
  expect(places.map((place) => problem('stock', place))).toEqual([
    'three.js has no particles that are lights.',
    'three.js has no LightField: each light is an object and a loop’s turn of its own.',
    ...[null, null, 'Rectangles of three.js have no end: its picture would be another one.'],
    'three.js has light profiles for spot lights of its WebGPURenderer alone.',
    'three.js has no LightField: each light is an object and a loop’s turn of its own.',
    'three.js has no particles that are lights.',
    ...[null, 'three.js has no Gouraud shading: it lights all materials in each pixel.', null],
  ]);
  // the picture of stock three, of the kinds that it has: points and spots, flat and Phong
  for (const index of [0, 1]) expect(found[`deferred planes-kind ${index}`].likeness!.reference).toBe('stock');
  expect(problem('multipass', 'planes-kind 0')).toBeNull();
  expect(problem('multipass', 'planes-kind 2')).toBe(
    'The naive multipass is measured with point lights alone, not with rectangles.',
  );
  expect(text).toContain('| rectangles |');
  expect(text).toContain('| Gouraud shading |');
});
