import { t } from '@farol/editing';
import type { LabRun } from '../results/LabRun';
import { deviceName } from '../words/device';

/** A unique name for each run: the user's, or device and date. */
export function runNames(runs: readonly LabRun[]): string[] {
  const names = runs.map(
    ({ name, surroundings: { device, date } }) => name || `${deviceName(device)}, ${date.slice(0, 10)}`,
  );
  return names.map((name, i) => {
    const same = names.filter((other) => other === name).length;
    return same === 1
      ? name
      : t('{name}, run {number}', {
          name,
          number: names.slice(0, i + 1).filter((other) => other === name).length,
        });
  });
}

/** Device, browser and date of runs in one line, with their warnings. */
export function sourceOf(runs: readonly LabRun[]): string {
  const lines = runs.map(({ surroundings: { device, browser, system, date, build, warnings } }) =>
    [
      ['Farol Lab', build, deviceName(device), browser, system, date.slice(0, 10)].filter(Boolean).join(', '),
      ...warnings,
    ].join('. '),
  );
  return [...new Set(lines)].join(' | ');
}
