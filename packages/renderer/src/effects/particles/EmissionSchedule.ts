import type { ParticleSettings } from './ParticleSettings';

/** Longest step of the particle simulation (s); longer times are split. */
export const LONGEST_STEP = 1 / 30;
/** Difference (s) below which times of emission count as equal. */
const CLOSE = 1e-9;

/** One step of the simulation, at most `LONGEST_STEP` long, and the particles that begin in it. */
export interface SimulationStep {
  /** Duration of the simulation step (s). */
  seconds: number;
  /** Number of the first particle that begins, counted from the last restart. */
  first: number;
  /** Number of particles that begin at the start of the step; `rated` more begin at equal intervals. */
  bursting: number;
  rated: number;
  /** Time from the start of the step to the first of the `rated` particles (s). */
  offset: number;
  interval: number;
  /** The emitter's time at the end of the step (s). */
  time: number;
}

type Emission = Pick<ParticleSettings, 'capacity' | 'rate' | 'bursts' | 'delay' | 'duration' | 'loop' | 'life'>;

/**
 * Schedule of the particles' beginnings: the emitter's clock, on the CPU. Particles are numbered; particle n has the slot n %
 * capacity.
 */
export class EmissionSchedule {
  /** Time since the emitter's last restart (s). */
  time = 0;
  /** Number of particles emitted since the last restart. */
  begun = 0;
  /** Number of the first particle that may still live; all earlier ones have ended. */
  oldest = 0;
  /** Whether, since the restart, particles could not begin because `capacity` was reached. */
  wasFull = false;
  /** Whether the emitter has emitted its last particle. */
  isOver = false;
  private cycle = 0;
  private nextBurst = 0;
  private sorted: ParticleSettings['bursts'] = [];
  private bursts: ParticleSettings['bursts'] | null = null;
  /** Fraction of the next particle that `rate` has accumulated, 0 to 1. */
  private share = 0;
  /**
   * Ring buffer of groups of particles that began together: for each the number after its last particle, and the time
   * when all of them have ended (s).
   */
  private ends = new Float64Array(4);
  private expiries = new Float64Array(4);
  private firstBatch = 0;
  private batches = 0;
  private readonly current: SimulationStep = {
    seconds: 0,
    first: 0,
    bursting: 0,
    rated: 0,
    offset: 0,
    interval: 0,
    time: 0,
  };

  restart(): void {
    this.time = this.begun = this.oldest = this.cycle = this.nextBurst = this.share = this.batches = 0;
    this.isOver = this.wasFull = false;
    this.bursts = null;
  }

  /**
   * Advances the time in one or several steps, none longer than LONGEST_STEP, with bursts between steps.
   * @param emits - whether particles begin
   * @param take - called with each step; the object is reused
   */
  advance(seconds: number, settings: Emission, emits: boolean, take: (step: SimulationStep) => void): void {
    this.follow(settings);
    const steps = Math.max(1, Math.ceil(seconds / LONGEST_STEP - CLOSE));
    const whole = seconds / steps;
    for (let i = 0; i < steps; i++) {
      for (let left = whole; left > CLOSE;) {
        const part = Math.min(left, this.untilEvent(settings));
        take(this.go(left - part > CLOSE ? part : left, settings, emits));
        left -= part;
      }
    }
  }

  /** Adopts changed bursts; skips those whose time has passed. */
  private follow({ bursts, delay }: Emission): void {
    if (bursts === this.bursts) return;
    const isFirst = this.bursts === null;
    // the time in the cycle is below 0 until the delay is over
    if (isFirst) this.cycle = -delay;
    this.bursts = bursts;
    this.sorted = bursts.toSorted((a, b) => a.time - b.time);
    const next = isFirst ? 0 : this.sorted.findIndex(({ time }) => time > this.cycle);
    this.nextBurst = next < 0 ? this.sorted.length : next;
  }

  /** Time (s) until the next burst or the end of the cycle, above 0. */
  private untilEvent({ duration, loop }: Emission): number {
    const { sorted } = this;
    if (duration > 0 && this.cycle >= duration - CLOSE) {
      this.isOver = !loop;
      if (loop) {
        this.cycle = 0;
        this.nextBurst = 0;
      }
    } else this.isOver = false;
    if (this.isOver) return Infinity;
    if (this.cycle < -CLOSE) return -this.cycle;
    const end = duration > 0 ? duration : Infinity;
    let event = end;
    for (let i = this.nextBurst; i < sorted.length; i++) {
      if (sorted[i].time <= this.cycle + CLOSE) continue; // a burst at the start of the step does not end it
      event = Math.min(end, sorted[i].time);
      break;
    }
    return event - this.cycle;
  }

  private go(seconds: number, settings: Emission, emits: boolean): SimulationStep {
    const { capacity, rate, life } = settings;
    const { sorted, current } = this;
    this.time += seconds;
    let bursting = 0;
    current.rated = 0;
    this.forget();
    if (!this.isOver && this.cycle >= -CLOSE) {
      for (; this.nextBurst < sorted.length && sorted[this.nextBurst].time <= this.cycle + CLOSE; this.nextBurst++)
        bursting += sorted[this.nextBurst].count;
      const made = this.share + (emits ? rate * seconds : 0);
      current.rated = Math.floor(made + CLOSE);
      current.interval = rate > 0 ? 1 / rate : 0;
      current.offset = (1 - this.share) * current.interval;
      this.share = Math.max(0, made - current.rated);
    }
    this.cycle += seconds;
    const room = capacity - (this.begun - this.oldest);
    if (!emits) bursting = 0;
    if (bursting + current.rated > room) this.wasFull = true;
    current.bursting = Math.min(bursting, room);
    current.rated = Math.min(current.rated, room - current.bursting);
    current.first = this.begun;
    current.seconds = seconds;
    current.time = this.time;
    this.begun += current.bursting + current.rated;
    if (this.begun > current.first) this.remember(this.time + life[1]);
    return current;
  }

  private remember(expiry: number): void {
    const { length } = this.ends;
    if (this.batches === length) {
      const order = (list: Float64Array) => {
        const grown = new Float64Array(2 * length);
        for (let i = 0; i < length; i++) grown[i] = list[(this.firstBatch + i) % length];
        return grown;
      };
      this.expiries = order(this.expiries);
      this.ends = order(this.ends);
      this.firstBatch = 0;
    }
    const at = (this.firstBatch + this.batches++) % this.ends.length;
    this.ends[at] = this.begun;
    this.expiries[at] = expiry;
  }

  /** Updates `oldest` by the particles that have ended. */
  private forget(): void {
    while (this.batches > 0 && this.expiries[this.firstBatch] <= this.time) {
      this.oldest = this.ends[this.firstBatch];
      this.firstBatch = (this.firstBatch + 1) % this.ends.length;
      this.batches--;
    }
  }
}
