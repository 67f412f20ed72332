import type { Reporter, TestCase, TestResult } from '@playwright/test/reporter';
import { FOUND } from './driven';

/** Prints a table of the tests, with a column for each browser: whether one passed, and the figures that it found. */
export default class BrowsersReporter implements Reporter {
  private readonly cells = new Map<string, Map<string, string>>();
  private readonly browsers = new Set<string>();
  private passed = 0;
  private failed = 0;

  onTestEnd(test: TestCase, { status, annotations }: TestResult): void {
    const said = (wanted: string) =>
      annotations.filter(({ type }) => type === wanted).map((each) => each.description ?? '');
    const browser = said('browser')[0] ?? test.parent.project()?.name ?? '';
    const row = this.cells.get(test.title) ?? new Map<string, string>();
    row.set(browser, [status === 'passed' ? 'pass' : 'FAIL', ...said(FOUND)].join(': '));
    this.cells.set(test.title, row);
    this.browsers.add(browser);
    if (status === 'passed') this.passed++;
    else this.failed++;
  }

  onEnd(): void {
    const line = (cells: readonly string[]) => `| ${cells.join(' | ')} |`;
    const browsers = [...this.browsers];
    console.log(`\n${line(['', ...browsers])}\n${line(['', ...browsers].map(() => '---'))}`);
    for (const [title, row] of this.cells) console.log(line([title, ...browsers.map((each) => row.get(each) ?? '')]));
    console.log(`\n${this.passed} passed, ${this.failed} failed`);
  }
}
