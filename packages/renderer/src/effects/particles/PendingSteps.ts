import { Matrix4 } from 'three';
import { EmissionSchedule, type SimulationStep } from './EmissionSchedule';
import type { ParticleSettings } from './ParticleSettings';

/** A simulation step that the GPU has not run yet. */
export interface PendingStep extends SimulationStep {
  /** World matrix of the emitter at the end of the step; that at its start is the previous step's. */
  readonly matrix: Matrix4;
}

/** Maximum number of steps kept while the emitter is not drawn. */
const MOST = 4096;
/** Number of pending steps at which `drop` first drops steps whose particles have all ended. */
const FEW = 64;

function makeStep(): PendingStep {
  return { seconds: 0, first: 0, bursting: 0, rated: 0, offset: 0, interval: 0, time: 0, matrix: new Matrix4() };
}

/** Simulation steps of an emitter that wait for the next frame in which it is drawn; the GPU then runs all of them. */
export class PendingSteps {
  readonly schedule = new EmissionSchedule();
  /** Pending steps; only the first `count` are valid. */
  readonly steps: PendingStep[] = [];
  count = 0;
  /** The emitter's world matrix at the start of the first pending step. */
  readonly start = new Matrix4();
  /** Whether all particles from before the first pending step have ended. */
  clears = true;
  private readonly last = new Matrix4();
  private readonly next = new Matrix4();
  private longestLife = 0;
  private from = 0;
  private length = 0;
  /** Number of steps at which `drop` runs next. */
  private limit = FEW;

  /** Restarts at the emitter's current world matrix. */
  restart(matrix: Matrix4): void {
    this.schedule.restart();
    this.count = 0;
    this.clears = true;
    this.longestLife = 0;
    this.limit = FEW;
    this.letGo();
    this.last.copy(matrix);
  }

  /** @param matrix - world matrix of the emitter at the end of the time @param emits - whether particles begin */
  advance(seconds: number, settings: ParticleSettings, matrix: Matrix4, emits: boolean): void {
    this.longestLife = Math.max(this.longestLife, settings.life[1]);
    if (this.count === 0) this.start.copy(this.last);
    this.next.copy(matrix);
    this.from = this.schedule.time;
    this.length = seconds;
    this.schedule.advance(seconds, settings, emits, this.push);
    this.last.copy(matrix);
  }

  /** Removes the pending steps: the GPU has simulated them. */
  done(): void {
    this.count = 0;
    this.clears = false;
    this.letGo();
  }

  /** Frees the memory of steps that gathered while the emitter was not drawn: 0.6 MB after a minute. */
  private letGo(): void {
    if (this.steps.length > FEW) this.steps.length = FEW;
  }

  private readonly push = (step: SimulationStep): void => {
    if (this.count >= this.limit) this.drop(step.time);
    const kept = (this.steps[this.count++] ??= makeStep());
    kept.seconds = step.seconds;
    kept.first = step.first;
    kept.bursting = step.bursting;
    kept.rated = step.rated;
    kept.offset = step.offset;
    kept.interval = step.interval;
    kept.time = step.time;
    const share = (step.time - this.from) / this.length;
    const a = this.last.elements;
    const b = this.next.elements;
    for (let i = 0; i < 16; i++) kept.matrix.elements[i] = a[i] + share * (b[i] - a[i]);
  };

  /** Drops steps whose particles have all ended and, if there are too many, half of the rest. */
  private drop(time: number): void {
    const { steps, count } = this;
    let first = 0;
    while (first < count && time - steps[first].time >= this.longestLife) first++;
    if (count === MOST) first = Math.max(first, MOST / 2);
    // the next drop comes once the number has doubled
    this.limit = Math.min(MOST, Math.max(FEW, 2 * (count - first)));
    if (first === 0) return;
    this.start.copy(steps[first - 1].matrix);
    this.steps.push(...steps.splice(0, first));
    this.count -= first;
    this.clears = true;
  }
}
