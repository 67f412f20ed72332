import { writeFileSync } from 'node:fs';
import { stripVTControlCharacters } from 'node:util';
import type { FullResult, Reporter, TestCase, TestError, TestResult } from '@playwright/test/reporter';
import { CHANCE, scenesByKind } from './chance';
import { COMPARISON, type Comparison, readComparison } from './comparison';
import { figuresOf } from './images';

interface Row {
  count: number;
  good: number;
  exceptions: number;
  largest: number;
  psnr: number;
  share: number;
  alpha: number;
}

/**
 * Prints the comparisons that tests recorded as a table, a row for each suite and technique, and names what is off. All of
 * them go to the file that FAROL_AGREE_FILE names, a line of JSON each.
 */
export default class AgreementReporter implements Reporter {
  private readonly rows = new Map<string, Row>();
  private readonly off: string[] = [];
  private readonly failed: string[] = [];
  private passed = 0;
  private readonly comparisons: string[] = [];
  private readonly scenes: string[] = [];

  onTestEnd(test: TestCase, { status, annotations, errors }: TestResult): void {
    if (status === 'passed') this.passed++;
    else this.failed.push([test.titlePath().slice(2).join(' > '), ...errors.map(said), status].join('\n  '));
    for (const { type, description = '' } of annotations) {
      if (type === CHANCE) this.scenes.push(description);
      if (type !== COMPARISON) continue;
      this.comparisons.push(description);
      this.add(readComparison(description));
    }
  }

  onEnd({ status }: FullResult): Promise<{ status: FullResult['status'] }> {
    const file = process.env.FAROL_AGREE_FILE;
    if (file) writeFileSync(file, `${[...this.comparisons, ...this.scenes].join('\n')}\n`);
    const lines = [...this.rows].sort(([a], [b]) => (a < b ? -1 : 1)).map(([key, row]) => tableLine(key, row));
    console.log(
      '\n| suite | technique | pictures | within limits | named exceptions | largest error | least PSNR (dB) | most pixels off | largest error of alpha |',
    );
    console.log('| --- | --- | --- | --- | --- | --- | --- | --- | --- |');
    for (const line of lines) console.log(line);
    const rows = [...this.rows.values()];
    const count = rows.reduce((sum, row) => sum + row.count, 0);
    const good = rows.reduce((sum, row) => sum + row.good, 0);
    const exceptions = rows.reduce((sum, row) => sum + row.exceptions, 0);
    for (const line of this.off) console.log(`off: ${line}`);
    for (const line of scenesByKind(this.scenes)) console.log(line);
    for (const line of this.failed) console.log(`failed: ${line}`);
    console.log(`\n${good} of ${count} pictures within the limits, ${exceptions} named exceptions; ${status}.`);
    console.log(`${this.passed} passed, ${this.failed.length} failed`);
    return Promise.resolve({ status: this.off.length > 0 ? 'failed' : status });
  }

  private add(comparison: Comparison): void {
    const { suite, technique, name, good, exception, largest, psnr, share, alpha } = comparison;
    const key = `${suite} | ${technique}`;
    const row = this.rows.get(key) ?? {
      count: 0,
      good: 0,
      exceptions: 0,
      largest: 0,
      psnr: Infinity,
      share: 0,
      alpha: 0,
    };
    row.count++;
    if (exception) row.exceptions++;
    else if (good) row.good++;
    else this.off.push(`${suite}: ${name}, ${technique}: ${figuresOf(comparison)}`);
    this.rows.set(key, row);
    if (exception) return;
    row.largest = Math.max(row.largest, largest);
    row.psnr = Math.min(row.psnr, psnr);
    row.share = Math.max(row.share, share);
    row.alpha = Math.max(row.alpha, alpha);
  }
}

/** The first lines of an error's message, without the colours of a terminal. */
function said({ message = '' }: TestError): string {
  return stripVTControlCharacters(message).split('\n').slice(0, 12).join('\n  ');
}

function tableLine(key: string, { count, good, exceptions, largest, psnr, share, alpha }: Row): string {
  return `| ${key} | ${count} | ${good} | ${exceptions} | ${largest.toExponential(1)} | ${psnr.toFixed(1)} | ${(share * 100).toFixed(3)}% | ${alpha.toExponential(1)} |`;
}
