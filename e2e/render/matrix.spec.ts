import type { CaseResult } from '../pages/matrix/runSheet';
import { isWhole } from '@farol/tools/extent';
import { caseVerdict } from '../support/caseVerdict';
import { strayExceptions } from './matrixExceptions';
import { figuresOf } from '../support/images';
import { recordComparison } from '../support/comparison';
import { parts } from '../support/parts';
import { expect, test } from '../support/benchTest';

/** Cases that are not to be seen. */
const HIDDEN = new Set(['shadow', 'material that is not visible', 'layers that the camera does not see']);

/**
 * The matrix: each material, map, geometry and order of drawing, in a cell of 32 × 32 pixels, by one forward technique and one
 * with a G-buffer, by all of them in `npm run verify`, in linear float against stock three. A cell that is off is named.
 */
function failure(result: CaseResult): string | null {
  const { sheet, case: name, technique, ...difference } = result;
  const { good, within, exception } = caseVerdict(result, Boolean(process.env.FAROL_GPU));
  recordComparison({ suite: sheet, technique, name, good, exception, ...difference });
  if (good) return null;
  const why = within ? ' (no exception is needed)' : '';
  return `${sheet}: ${name}, ${technique}: ${figuresOf(difference)}${why}`;
}

// a hundred and sixty cases by ten techniques, on a software rasteriser that other tests share
test.describe.configure({ timeout: 480_000 });

const sheets = ['materials', 'maps', 'geometry', 'order', 'glTF', 'shaders', 'shaders of lights'] as const;
/**
 * Whether the slice draws a sheet by the forward technique (0) or by that with a G-buffer (1): forward, maps are three's own
 * code; agreement.spec.ts has the materials and each kind of geometry by every technique; the others are drawn forward in
 * most cases.
 */
const BY_ONE: Record<(typeof sheets)[number], 0 | 1> = {
  materials: 1,
  maps: 1,
  geometry: 1,
  order: 0,
  glTF: 1,
  shaders: 0,
  'shaders of lights': 1,
};

/**
 * Step between cases that the slice draws. agreement.spec.ts draws the lit materials and the kinds of geometry; a sheet of glTF
 * holds materials of the other sheets, after a file; of changed shaders, each chunk has two or three.
 */
const EVERY: Partial<Record<(typeof sheets)[number], number>> = {
  materials: 2,
  geometry: 2,
  glTF: 2,
  shaders: 2,
};

// one page for all sheets, unless many browsers share them: most of their time goes to shaders, many of which they share
for (const [part, listed] of parts(sheets, 1).entries()) {
  test(`each case of each sheet, part ${part + 1}`, async ({ benchPage: page }) => {
    for (const sheet of listed) {
      const { results, unseen, known } = await page.evaluate(
        ([name, one, every]) => {
          const { drawn, runSheet, techniqueInTurn, techniquesInTurn } = window.testPage;
          return runSheet(name, techniqueInTurn(one, techniquesInTurn(4, drawn)), every);
        },
        [sheet, BY_ONE[sheet], isWhole ? 1 : (EVERY[sheet] ?? 1)] as const,
      );
      expect
        .soft(
          unseen.filter((name) => !HIDDEN.has(name)),
          `cases of the sheet ${sheet} that stock three does not show`,
        )
        .toEqual([]);
      expect.soft(results.map(failure).filter((text) => text !== null)).toEqual([]);
      expect.soft(strayExceptions(sheet, known), 'exceptions of no case').toEqual([]);
    }
  });
}

/** The settings are split among as many tests as there are cores, where all techniques draw them. */
const EIGHTHS = [0, 1, 2, 3, 4, 5, 6, 7];
for (const [part, shares] of parts(EIGHTHS, 1).entries()) {
  test(`each setting of renderer, scene and camera, part ${part + 1}`, async ({ benchPage: page }) => {
    const { results, known } = await page.evaluate(
      ([shares, eighths]) => {
        const { drawn, runSettings, settingNames, techniquesInTurn } = window.testPage;
        const names = settingNames.filter((_, index) => shares.includes(index % eighths));
        return { results: runSettings(names, techniquesInTurn(3, drawn)), known: settingNames };
      },
      [shares, EIGHTHS.length] as const,
    );
    expect(results.length).toBeGreaterThan(0);
    expect.soft(results.map(failure).filter((text) => text !== null)).toEqual([]);
    for (const sheet of ['settings', 'settings, 8 bits'])
      expect.soft(strayExceptions(sheet, known), 'exceptions of no case').toEqual([]);
  });
}
