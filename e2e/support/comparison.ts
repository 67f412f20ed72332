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

/** Leaves a comparison in the report of the running test. */
export function recordComparison({ psnr, ...rest }: Comparison): void {
  // JSON has neither Infinity, the PSNR of equal pictures, nor NaN, the error of a picture that holds one
  const description = JSON.stringify({ ...rest, psnr: Math.min(psnr, 999) }, (_key, value: unknown) =>
    Number.isNaN(value) ? 'NaN' : value,
  );
  test.info().annotations.push({ type: COMPARISON, description });
}
