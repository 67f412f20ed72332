import { REVISION } from 'three';
import type { CaseResult } from '../pages/matrix/runSheet';
import { exceptionOf } from '../render/matrixExceptions';

/** Techniques that run three's own shaders; what a G-buffer or light buffer holds is rounded. */
const FORWARD = new Set(['forward', 'forward-single-pass', 'tiled-forward', 'forward-plus', 'clustered-forward']);
const LARGEST = 1e-4;
/** Largest difference in linear values of two neighbours of 8 bits in sRGB. */
const STEP = 0.0091;
const PSNR = 55;
/** One pixel of a cell is 0.098%. */
const SHARE = 0.001;

/** How a case of the matrix is to be taken. */
export interface CaseVerdict {
  readonly good: boolean;
  /** Whether it is within the limits of all cases. */
  readonly within: boolean;
  /** Whether it is a named exception, within the limits of that. */
  readonly exception: boolean;
}

/**
 * @param mayBeNeedless - whether an exception may be within the limits of all cases: they are measured on Chromium's software
 *   rasteriser, and another device may round to one side of an edge
 */
export function caseVerdict(
  { sheet, case: name, technique, largest, psnr, share, alpha }: CaseResult,
  mayBeNeedless = true,
): CaseVerdict {
  // of 8 bits, a value on the edge of rounding may go either way: a step is 48 dB
  const eight = sheet.endsWith('8 bits');
  const most = eight ? STEP : LARGEST;
  const near = FORWARD.has(technique) ? largest <= most : (eight || psnr >= PSNR) && share <= SHARE;
  const within = near && alpha <= LARGEST;
  const limits = exceptionOf(technique, `${sheet}: ${name}`);
  const exception = limits !== undefined && alpha <= LARGEST && psnr >= limits.psnr && share <= limits.share;
  // an exception may also be needless in an older three, where lit surfaces are drawn forward: see `npm run compat`
  const allowed = exception && (!within || mayBeNeedless || Number(REVISION) < 186);
  return { good: limits === undefined ? within : allowed, within, exception };
}
