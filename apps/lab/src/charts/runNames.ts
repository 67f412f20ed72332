import type { LabRun } from '../results/LabRun';

/** A name for each run, all different: the user's own, else device and date. */
export function runNames(runs: readonly LabRun[]): string[] {
  const names = runs.map(
    ({ name, surroundings }) => name || `${shortDevice(surroundings.device)}, ${day(surroundings)}`,
  );
  return names.map((name, i) => {
    const same = names.filter((other) => other === name).length;
    return same === 1 ? name : `${name}, run ${names.slice(0, i + 1).filter((other) => other === name).length}`;
  });
}

function day({ date }: { date: string }): string {
  return date.slice(0, 10);
}

/** Name of a device without what its driver adds: `ANGLE (NVIDIA, NVIDIA H200 (0x…), Vulkan)` is `NVIDIA H200`. */
export function shortDevice(device: string): string {
  const angle = /^ANGLE \([^,]*, (.*)\)$/.exec(device.trim())?.[1] ?? device;
  const model = angle.replace(/^Vulkan [\d.]+ \((.*?)\).*$/, '$1').split(/,| Direct3D| OpenGL| \(0x| \(Subzero/)[0];
  return model.trim() || 'unknown device';
}

/** One line on where and when runs were made, with their warnings. */
export function sourceOf(runs: readonly LabRun[]): string {
  const lines = runs.map(({ surroundings: { device, browser, system, date, build, warnings } }) =>
    [
      ['Farol Lab', build, shortDevice(device), browser, system, date.slice(0, 10)].filter(Boolean).join(', '),
      ...warnings,
    ].join('. '),
  );
  return [...new Set(lines)].join(' | ');
}
