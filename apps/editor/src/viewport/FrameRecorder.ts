import type { FarolInfo } from '@farol/renderer';

/** Times (ms) of one render pass in the last frames, as ring buffers; -1 where it did not run or was not measured. */
export interface PassTimes {
  readonly name: string;
  readonly cpu: Float32Array;
  readonly gpu: Float32Array;
}

/** Times of every render pass in the last frames. Allocates only when a new pass appears. */
export class FrameRecorder {
  /** Number of frames recorded; the last one is at `(frames - 1) % length` of the rings. */
  frames = 0;

  private readonly byName = new Map<string, PassTimes>();

  /** @param length - number of frames kept */
  constructor(readonly length = 120) {}

  /** Passes that ran in one of the kept frames, in the order of their first run. */
  get passes(): PassTimes[] {
    return [...this.byName.values()].filter(({ cpu }) => cpu.some((ms) => ms >= 0));
  }

  /** Records a frame that was drawn. */
  add({ passes }: Pick<FarolInfo, 'passes'>): void {
    const at = this.frames++ % this.length;
    for (const times of this.byName.values()) times.cpu[at] = times.gpu[at] = -1;
    for (const { name, cpuMs, gpuMs } of passes) {
      let times = this.byName.get(name);
      if (!times) {
        times = { name, cpu: new Float32Array(this.length).fill(-1), gpu: new Float32Array(this.length).fill(-1) };
        this.byName.set(name, times);
      }
      times.cpu[at] = Math.max(0, times.cpu[at]) + cpuMs;
      if (gpuMs !== null) times.gpu[at] = gpuMs;
    }
  }

  /** Records GPU times of the last frame, which arrive after it was drawn. */
  addTimes({ passes }: Pick<FarolInfo, 'passes'>): void {
    const at = (this.frames - 1) % this.length;
    for (const { name, gpuMs } of passes) {
      const times = this.byName.get(name);
      if (times && gpuMs !== null) times.gpu[at] = gpuMs;
    }
  }

  /** Duration (ms) of the longest kept frame, as the sum of its passes. */
  longest(kind: 'cpu' | 'gpu'): number {
    let longest = 0;
    for (let i = 0; i < this.length; i++) {
      let sum = 0;
      for (const times of this.byName.values()) sum += Math.max(0, times[kind][i]);
      longest = Math.max(longest, sum);
    }
    return longest;
  }

  /** Mean over the frames with a measured time (ms); null when there are none. */
  mean(times: PassTimes, kind: 'cpu' | 'gpu'): number | null {
    let [sum, count] = [0, 0];
    for (const ms of times[kind]) {
      if (ms < 0) continue;
      sum += ms;
      count++;
    }
    return count > 0 ? sum / count : null;
  }
}
