import { test } from '@playwright/test';
import type { Difference } from './images';

/** One picture of a technique against stock three's, as `npm run agree` counts them. */
export interface Comparison extends Difference {
  /** Folder of cases, a row of the table: 'materials', 'scenes', 'models', ... */
  readonly suite: string;
  readonly technique: string;
  readonly name: string;
  /** Whether the figures are within the limits of the suite, or an exception that is named with its reason. */
  readonly good: boolean;
  readonly exception?: boolean;
}

export const COMPARISON = 'comparison';

/** Numbers that JSON lacks, by name: Infinity is the PSNR of equal pictures, NaN the error of a picture that holds one. */
const special = new Map([NaN, Infinity, -Infinity].map((value) => [String(value), value]));

/** Leaves a comparison in the report of the running test. */
export function recordComparison(comparison: Comparison): void {
  const description = JSON.stringify(comparison, (_key, value: unknown) =>
    typeof value === 'number' && !Number.isFinite(value) ? String(value) : value,
  );
  test.info().annotations.push({ type: COMPARISON, description });
}

/** Numbers of a record in place of their names. */
export const numbersOf = <T extends object>(record: T): T =>
  Object.fromEntries(
    Object.entries(record).map(([key, value]) => [
      key,
      key === 'name' ? value : (special.get(value as string) ?? value),
    ]),
  ) as T;

/** Reads what {@link recordComparison} left. */
export const readComparison = (description: string): Comparison => numbersOf(JSON.parse(description) as Comparison);
