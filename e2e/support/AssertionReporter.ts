import type { FullResult, Reporter, TestCase, TestResult, TestStep } from '@playwright/test/reporter';

const asserts = (steps: readonly TestStep[]): boolean =>
  steps.some(({ category, steps }) => category === 'expect' || (category !== 'hook' && asserts(steps)));

/** Fails a run in which a test passed without an expectation in its body, such as one whose list of results was empty. */
export default class AssertionReporter implements Reporter {
  private readonly empty: string[] = [];

  onTestEnd({ location, title }: TestCase, { status, steps }: TestResult): void {
    if (status === 'passed' && !asserts(steps)) this.empty.push(`${location.file}:${location.line} ${title}`);
  }

  async onEnd(): Promise<Partial<FullResult> | undefined> {
    if (this.empty.length === 0) return undefined;
    console.error(`Tests that expected nothing:\n  ${this.empty.join('\n  ')}`);
    return { status: 'failed' };
  }

  printsToStdio(): boolean {
    return false;
  }
}
