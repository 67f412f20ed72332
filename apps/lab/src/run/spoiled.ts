import { median } from '../measure/spread';

/** Relative difference between the first and the last turn above which a drift is reported. */
const DRIFT = 0.15;
/** Refresh rates of displays (Hz). */
const DISPLAYS = [60, 72, 75, 90, 120, 144, 165, 240];
/** Relative difference from a display's period below which a frame seems to wait for the display. */
const NEAR = 0.01;

/** Samples of one competitor in one case. */
export interface Turns {
  /** Samples of each turn (ms). */
  readonly frame: readonly (readonly number[])[];
  readonly cpu: readonly (readonly number[])[];
  readonly gpu: readonly (readonly number[])[];
}

/** Warnings about measured times, each a sentence: a drift from turn to turn, a wait for the display. */
export function spoiled({ frame, cpu, gpu }: Turns): string[] {
  const found: string[] = [];
  const turns = frame.filter((turn) => turn.length > 0).map(median);
  if (turns.length >= 2) {
    const change = turns[turns.length - 1] / turns[0] - 1;
    if (Math.abs(change) > DRIFT) {
      const how = change > 0 ? 'slower' : 'faster';
      found.push(
        `The last turn was ${Math.round(Math.abs(change) * 100)}% ${how} than the first: the machine was busy with other things, or changed its clock.`,
      );
    }
  }
  const whole = median(turns);
  const work = Math.max(median(cpu.flat()) || 0, median(gpu.flat()) || 0);
  const rate = DISPLAYS.find((hertz) => Math.abs((whole * hertz) / 1000 - 1) < NEAR);
  const steady = turns.every((turn) => Math.abs(turn / whole - 1) < NEAR);
  if (rate !== undefined && steady && turns.length >= 2 && work > 0 && work < whole / 2) {
    found.push(`The browser seems to wait for the display (${rate} Hz): the frame itself takes less.`);
  }
  return found;
}
