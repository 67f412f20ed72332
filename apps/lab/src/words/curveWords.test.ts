import { describe, expect, test } from 'vitest';
import { curveWords } from './curveWords';
import { exactly, madeUpRun } from './madeUpRun';

const wordsOf = (...parameters: Parameters<typeof madeUpRun>): string[] => {
  const run = madeUpRun(...parameters);
  return curveWords(run, run.plan.series[0], 'frame');
};

describe('sentences of a series', () => {
  test('one competitor is not called the fastest', () => {
    expect(wordsOf([10, 100], { deferred: [1, 2] })).toEqual([
      'Deferred alone has figures: 1 ms with 10 lights, 2 ms with 100 lights.',
    ]);
    expect(wordsOf([1], { deferred: [1] })).toEqual(['Deferred alone has figures: 1 ms with 1 light.']);
  });

  test('who is fastest where, and where forward falls behind deferred on log axes', () => {
    // log-log lines 1 → 100 and 10 → 10 over 1 → 100 cross in the middle: 10
    expect(wordsOf([1, 100], { forward: [1, 100], deferred: [10, 10] })).toEqual([
      'Forward is the fastest with 1 light (1 ms), deferred with 100 lights (10 ms).',
      'Forward falls behind deferred from about 10 lights on (between 1 and 100 measured), and takes 10 times as long with 100 lights.',
    ]);
  });

  test('along an axis of names each case stands by itself, and the first is what the others cost', () => {
    const refused = 'three.js has no LightField.';
    const times = { 'clustered-forward': [1, 2, 3], deferred: [2, 1.5, 3.5], stock: [9, refused, refused] };
    expect(wordsOf([0, 2, 4], times, 'kind')).toEqual([
      'Clustered forward is the fastest with points (1 ms), deferred with rectangles (1.5 ms), clustered forward with a LightField (3 ms).',
      'Clustered forward takes 1 ms with points, with rectangles 2 times as long (2 ms) and with a LightField 3 times as long (3 ms).',
      'With points clustered forward takes 1 ms, three’s WebGLRenderer 9 ms (9 times as long).',
      'No figure for three’s WebGLRenderer with rectangles and a LightField: three.js has no LightField.',
    ]);
    expect(wordsOf([1, 2], { forward: [2, 1], deferred: [3, 2] }, 'shading').slice(0, 2)).toEqual([
      'Forward is the fastest throughout.',
      'Forward takes 2 ms with flat shading, with Gouraud shading 2 times as fast (1 ms).',
    ]);
  });

  test('a list of names has no commas within names', () => {
    expect(wordsOf([10], { 'forward-single-pass': [1], forward: [1], deferred: [1] })[0]).toBe(
      'Single-pass forward, forward and deferred tie for the fastest with 10 lights (1 ms).',
    );
  });

  test('neighbouring cases of one winner are one range', () => {
    const [sentence] = wordsOf([1, 4, 25, 100], { forward: [1, 2, 9, 40], 'tiled-deferred': [3, 3, 3, 4] });
    expect(sentence).toBe(
      'Forward is the fastest from 1 to 4 lights (2 ms there), tiled deferred from 25 to 100 lights (4 ms there).',
    );
  });

  test('a winner of all cases wins throughout', () => {
    const [sentence] = wordsOf([1, 1000], { 'light-prepass': [2, 30], inferred: [1, 20] });
    expect(sentence).toBe('Inferred is the fastest throughout: 1 ms with 1 light, 20 ms with 1,000 lights.');
  });

  test('times whose spreads overlap tie', () => {
    const wide = { median: 1, low: 0.8, high: 1.4, samples: 9 };
    expect(wordsOf([10, 50], { forward: [wide, wide], deferred: [1.2, 1.3] })).toEqual([
      'Forward and deferred tie for the fastest throughout: 1 ms with 10 lights, 1 ms with 50 lights.',
      'Forward and deferred cannot be told apart here: their spreads overlap.',
    ]);
  });

  test('ranges with ties are said in full', () => {
    const [sentence] = wordsOf([10, 50, 90], { forward: [1, 3, 3], deferred: [2, 1, 1], inferred: [3, 1.01, 1.01] });
    expect(sentence).toBe(
      'Forward is the fastest with 10 lights (1 ms); deferred and inferred tie for the fastest from 50 to 90 lights (1 ms there).',
    );
  });

  test('a winner that only ties in some cases is not said to win them', () => {
    const [sentence] = wordsOf([1, 25, 100], { stock: [1, 1.02, 5], deferred: [2, 1, 1] });
    expect(sentence).toBe(
      'Three’s WebGLRenderer is the fastest or ties for it from 1 to 25 lights (1.02 ms there); deferred is the fastest with 100 lights (1 ms).',
    );
  });

  test('auto draws by another technique: it is never the fastest', () => {
    const [sentence] = wordsOf([10, 50], { auto: [0.5, 0.5], deferred: [1, 1], inferred: [2, 2] });
    expect(sentence).toContain('Deferred is the fastest throughout');
  });

  test('who cannot draw, from where on, and why', () => {
    const reason = 'Its uniforms hold 64 lights.';
    const sentences = wordsOf([10, 100, 1000], {
      stock: [2, reason, reason],
      babylon: [reason, reason, reason],
      deferred: [1, 1, 1],
    });
    expect(sentences).toContain('No figure for three’s WebGLRenderer from 100 lights on: Its uniforms hold 64 lights.');
    expect(sentences).toContain('No figure for Babylon.js in any case: Its uniforms hold 64 lights.');
    expect(sentences).toContain('With 10 lights deferred takes 1 ms, three’s WebGLRenderer 2 ms (2 times as long).');
  });

  test('competitors with one reason share a sentence; beyond three reasons the table is named', () => {
    const sentences = wordsOf([10], {
      deferred: [1],
      ...{ forward: ['A.'], inferred: ['A.'], stock: ['B.'], multipass: ['C.'], babylon: ['D.'] },
    });
    expect(sentences.slice(1)).toEqual([
      'No figure for forward and inferred in any case: A.',
      'No figure for three’s WebGLRenderer in any case: B.',
      'No figure for naive multipass in any case: C.',
      'One more reason stands in the table.',
    ]);
  });

  test('what stopped everybody is said once, without their names', () => {
    const late = 'Not measured: the run may take 80 s, and they were over.';
    expect(wordsOf([10, 100], { auto: [late, late], forward: [late, late] })).toEqual([
      `No figure in any case: ${late}`,
    ]);
  });

  test('figures that are no numbers, and cases without a row, are not compared', () => {
    const broken = { median: Number.NaN, low: Number.NaN, high: Number.NaN, samples: 0 };
    expect(wordsOf([10, 100], { forward: [broken, null], deferred: [exactly(1), exactly(2)] })).toEqual([
      'Deferred alone has figures: 1 ms with 10 lights, 2 ms with 100 lights.',
    ]);
    expect(wordsOf([10], { forward: [null] })).toEqual(['Nothing has been measured here yet.']);
    expect(wordsOf([10], { forward: ['No WebGL 2.'] })).toEqual(['No figure for forward in any case: No WebGL 2.']);
  });

  test('a metric without figures says so', () => {
    const run = madeUpRun([10], { deferred: [1] });
    expect(curveWords(run, run.plan.series[0], 'gpu')).toEqual([
      'No GPU time was measured here: the device has no timer.',
    ]);
  });

  test('another time than that of frames is named', () => {
    const run = madeUpRun([10, 100], { deferred: [1, 2], inferred: [3, 4] });
    for (const row of run.rows) row.gpu = row.frame;
    const ofBoth = (competitors: string[]): string => {
      const rows = run.rows.filter(({ competitor }) => competitors.includes(competitor));
      return curveWords({ ...run, rows }, run.plan.series[0], 'gpu')[0];
    };
    expect(ofBoth(['deferred', 'inferred'])).toContain('By GPU time deferred is the fastest throughout');
    expect(ofBoth(['inferred'])).toContain('By GPU time inferred alone has figures');
  });

  test('doubtful figures are counted', () => {
    const run = madeUpRun([10, 100], { deferred: [1, 2], inferred: [3, 4] });
    run.rows[1].warnings.push('The tab was hidden.');
    expect(curveWords(run, run.plan.series[0], 'frame')).toContain(
      'One figure is doubtful, deferred’s with 100 lights: The tab was hidden.',
    );
  });

  test('curves that cross more than once have no crossing point', () => {
    const sentences = wordsOf([1, 10, 100], { forward: [1, 9, 2], deferred: [3, 3, 3] });
    expect(sentences[1]).toBe(
      'Forward and deferred change places more than once: forward is ahead with 1 and 100 lights, behind with 10 lights.',
    );
  });

  test('forward that stays ahead, and one that is behind from the start', () => {
    expect(wordsOf([1, 10], { forward: [1, 2], deferred: [3, 3] })[1]).toBe(
      'Forward never falls behind deferred here: it is still 1.5 times as fast with 10 lights.',
    );
    expect(wordsOf([10, 20], { forward: [4, 9], deferred: [3, 3] })[1]).toBe(
      'Forward is behind deferred already with 10 lights, and takes 3 times as long with 20 lights.',
    );
  });

  test('pictures are named by their sides, other axes by their units', () => {
    expect(wordsOf([921_600], { deferred: [1] }, 'pixels')[0]).toContain('with 1280 × 720');
    expect(wordsOf([1, 16], { deferred: [1, 2] }, 'shadows')[0]).toContain(
      'with 1 shadowed light, 2 ms with 16 shadowed',
    );
  });
});
