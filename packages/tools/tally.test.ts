import { expect, it } from 'vitest';
import { addTallies, playwrightTally, tallyLine, vitestTally } from './tally.mjs';

it('sums unit and browser tests into one plain line', () => {
  const unit = vitestTally({ numPassedTests: 400, numFailedTests: 0, testResults: [] });
  const browser = playwrightTally({ stats: { expected: 12, unexpected: 1, flaky: 0 }, errors: [] });
  expect(tallyLine(addTallies(unit, browser))).toBe('412 passed, 1 failed');
});

it('counts a file that does not load, once', () => {
  const broken = { status: 'failed', assertionResults: [] };
  const red = { status: 'failed', assertionResults: [{ status: 'failed' }, { status: 'passed' }] };
  expect(vitestTally({ numPassedTests: 1, numFailedTests: 1, testResults: [broken, red] }).failed).toBe(2);
  expect(playwrightTally({ stats: { expected: 0, unexpected: 0, flaky: 0 }, errors: [{}] }).failed).toBe(1);
});
