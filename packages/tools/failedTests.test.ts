import { expect, it } from 'vitest';
import { failedPlaywrightTests, failedVitestTests } from './failedTests.mjs';

it('finds the failed tests of a Playwright report, however deep', () => {
  const spec = (title: string, ok: boolean, line: number) => ({ title, ok, file: 'editor/a.spec.ts', line });
  const inner = { title: 'on a phone', specs: [spec('opens', false, 9), spec('closes', true, 12)] };
  const report = { suites: [{ title: 'editor/a.spec.ts', specs: [spec('draws', false, 3)], suites: [inner] }] };
  expect(failedPlaywrightTests(report)).toEqual([
    { title: 'editor/a.spec.ts > draws', place: 'editor/a.spec.ts:3' },
    { title: 'editor/a.spec.ts > on a phone > opens', place: 'editor/a.spec.ts:9' },
  ]);
});

it('finds the failed tests of a Vitest report, and files that did not load', () => {
  const red = { status: 'failed', fullName: 'adds' };
  const report = {
    testResults: [
      { name: '/farol/a.test.ts', status: 'failed', assertionResults: [red, { status: 'passed', fullName: 'b' }] },
      { name: '/farol/b.test.ts', status: 'failed', assertionResults: [] },
      { name: '/farol/c.test.ts', status: 'passed', assertionResults: [] },
    ],
  };
  expect(failedVitestTests(report, '/farol')).toEqual([
    { title: 'a.test.ts > adds', place: 'a.test.ts' },
    { title: 'b.test.ts', place: 'b.test.ts' },
  ]);
});
