import type { Scene } from '@farol/engine';
import { Signal } from './Signal';

export type SimulationState = 'stopped' | 'playing' | 'paused';

/** Longest time that one frame may advance (s): after a pause of the page the scene does not leap. */
const LONGEST_STEP = 0.1;

/** What `step` advances by (s). */
const STEP = 1 / 60;

/** Plays, pauses and stops a scene. What it moves is no edit: stopping puts everything back to where it was authored. */
export class Simulation {
  /** Emits when the state changes, and after each `step`. */
  readonly changed = new Signal();

  private current: SimulationState = 'stopped';

  /** @param getScene - the scene of the document */
  constructor(private readonly getScene: () => Scene) {}

  get state(): SimulationState {
    return this.current;
  }

  get isPlaying(): boolean {
    return this.current === 'playing';
  }

  play(): void {
    this.enter('playing');
  }

  /** Holds the scene as it is at this moment. */
  pause(): void {
    if (this.isPlaying) this.enter('paused');
  }

  /** Advances a scene that does not play by one sixtieth of a second. */
  step(): void {
    if (this.isPlaying) return this.pause();
    this.getScene().update(STEP);
    this.current = 'paused';
    this.changed.emit();
  }

  /** Time 0, and every object where it was authored; edits made meanwhile stay. */
  stop(): void {
    if (this.current === 'stopped') return;
    this.getScene().reset();
    this.enter('stopped');
  }

  /** Another scene came: nothing plays. */
  restart(): void {
    this.enter('stopped');
  }

  /** Called each frame. @param deltaSeconds - time since the last one; no more than a tenth of a second counts */
  advance(deltaSeconds: number): void {
    if (this.isPlaying) this.getScene().update(Math.min(Math.max(deltaSeconds, 0), LONGEST_STEP));
  }

  private enter(state: SimulationState): void {
    if (state === this.current) return;
    this.current = state;
    this.changed.emit();
  }
}
