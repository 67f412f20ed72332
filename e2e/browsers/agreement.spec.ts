import { extent, isWhole } from '@farol/tools/extent';
import { figuresOf } from '../support/images';
import { caseVerdict } from '../support/caseVerdict';
import { numbersOf } from '../support/comparison';
import { expect, test } from './driven';

const core = ['forward', 'clustered-forward', 'deferred', 'tiled-deferred'] as const;
const others = [
  'forward-single-pass',
  'forward-plus',
  'tiled-forward',
  'clustered-deferred',
  'light-prepass',
  'inferred',
] as const;
const techniques = isWhole ? [...core, ...others] : core;
/** Sheets of the matrix: see render/matrix.spec.ts. */
const sheets = ['materials', 'maps', 'geometry', 'order', 'glTF', 'shaders', 'shaders of lights'] as const;

for (const technique of techniques) {
  test(`matrix by ${technique}, as stock three in this browser`, async ({ driven, found }) => {
    // one page for all: stock three's programs are compiled once
    if (!(await driven.evaluate(() => 'testPage' in window))) {
      await driven.open(`${process.env.FAROL_PAGES_URL}?tests=${extent}`);
      await driven.until(() => 'testPage' in window);
    }
    const results = [];
    for (const sheet of sheets) {
      const drawn = await driven.evaluate(([sheet, technique]) => window.testPage.runSheet(sheet, [technique]), [
        sheet,
        technique,
      ] as const);
      results.push(...drawn.results.map(numbersOf));
    }
    if (isWhole) {
      const drawn = await driven.evaluate(
        (technique) => window.testPage.runSettings(window.testPage.settingNames, [technique]),
        technique,
      );
      results.push(...drawn.map(numbersOf));
    }
    expect(results.length).toBeGreaterThan(100);
    const verdicts = results.map((result) => ({ result, ...caseVerdict(result) }));
    const off = verdicts.filter(({ good }) => !good);
    const measured = verdicts.filter(({ exception }) => !exception).map(({ result }) => result.psnr);
    found(`${results.length - off.length} of ${results.length}, ${Math.min(...measured).toFixed(1)} dB and more`);
    expect(off.map(({ result }) => `${result.sheet}: ${result.case}: ${figuresOf(result)}`)).toEqual([]);
  });
}
