import { Matrix4 } from 'three';
import { EmissionSchedule, type SimulationStep } from './EmissionSchedule';
import type { ParticleSettings } from './ParticleSettings';

/** A step that the GPU has yet to make. */
export interface PendingStep extends SimulationStep {
  /** World matrix of the emitter at the end of the step; that of the step before is the one at its start. */
  readonly matrix: Matrix4;
}

/** Steps that are kept at most while nobody draws the emitter. */
const MOST = 4096;
/** Steps after which it is first looked which of them are of particles that have all ended. */
const FEW = 64;

function makeStep(): PendingStep {
  return { seconds: 0, first: 0, bursting: 0, rated: 0, offset: 0, interval: 0, time: 0, matrix: new Matrix4() };
}

/**
 * Simulation steps of an emitter that wait for the next frame in which it is drawn; the GPU then makes all of them.
 */
export class PendingSteps {
  readonly schedule = new EmissionSchedule();
  /** The steps, the first `count` of them. */
  readonly steps: PendingStep[] = [];
  count = 0;
  /** The emitter's world matrix at the start of the first of them. */
  readonly start = new Matrix4();
  /** Whether all particles from before the first of them have ended. */
  clears = true;
  private readonly last = new Matrix4();
  private readonly next = new Matrix4();
  private longestLife = 0;
  private from = 0;
  private length = 0;
  /** Steps at which it is looked again which are needed still. */
  private limit = FEW;

  /** No particle has begun, and the emitter is where it is. */
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

  /** Says that the GPU has made all of them. */
  done(): void {
    this.count = 0;
    this.clears = false;
    this.letGo();
  }

  /** Lets go of the room for steps that came while nobody drew the emitter: 0.6 MB after a minute. */
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

  /** Lets go of steps of which no particle lives still, and, where there are too many, of half of them. */
  private drop(time: number): void {
    const { steps, count } = this;
    let first = 0;
    while (first < count && time - steps[first].time >= this.longestLife) first++;
    if (count === MOST) first = Math.max(first, MOST / 2);
    // at most half of what is kept is of no use
    this.limit = Math.min(MOST, Math.max(FEW, 2 * (count - first)));
    if (first === 0) return;
    this.start.copy(steps[first - 1].matrix);
    this.steps.push(...steps.splice(0, first));
    this.count -= first;
    this.clears = true;
  }
}
