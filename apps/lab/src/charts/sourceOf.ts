import type { LabRun } from '../results/LabRun';
import { shortDevice } from './runNames';

/** Where and when runs were made and what spoils them, in a line. */
export function sourceOf(runs: readonly LabRun[]): string {
  const lines = runs.map(({ surroundings: { device, browser, system, date, build, warnings } }) =>
    [
      ['Farol Lab', build, shortDevice(device), browser, system, date.slice(0, 10)].filter(Boolean).join(', '),
      ...warnings,
    ].join('. '),
  );
  return [...new Set(lines)].join(' | ');
}
