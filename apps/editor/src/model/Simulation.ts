import { Signal } from '@farol/editing';
import type { Scene } from '@farol/engine';

export type SimulationState = 'stopped' | 'playing' | 'paused';

/** Longest time that one frame may advance (s): after a pause of the page the scene does not leap. */
const LONGEST_STEP = 0.1;

/** What `step` advances by (s). */
const STEP = 1 / 60;

/** Plays, pauses and stops a scene: stopping puts everything back to what it was when it began to play. */
export class Simulation {
  /** Emits when the state changes, and after each `step`. */
  readonly changed = new Signal();

  private current: SimulationState = 'stopped';

  /**
   * @param getScene - the scene of the document
   * @param edits - told when it begins to play, and to put the scene back to time 0 when it stops
   */
  constructor(
    private readonly getScene: () => Scene,
    private readonly edits: { begin(): void; end(reset: () => void): void; abort(): void },
  ) {}

  get state(): SimulationState {
    return this.current;
  }

  get isPlaying(): boolean {
    return this.current === 'playing';
  }

  play(): void {
    if (this.current === 'stopped') this.edits.begin();
    this.enter('playing');
  }

  /** Holds the scene as it is at this moment. */
  pause(): void {
    if (!this.isPlaying) return;
    this.getScene().pause();
    this.enter('paused');
  }

  /** Advances a scene that does not play by one sixtieth of a second. */
  step(): void {
    if (this.isPlaying) return this.pause();
    if (this.current === 'stopped') this.edits.begin();
    this.getScene().update(STEP);
    this.getScene().pause();
    this.current = 'paused';
    this.changed.emit();
  }

  /** Time 0, and the scene exactly as it was when it began to play. What was edited meanwhile: see `PlayEdits`. */
  stop(): void {
    if (this.current === 'stopped') return;
    this.edits.end(() => this.getScene().reset());
    this.enter('stopped');
  }

  /** Another scene came: nothing plays. */
  restart(): void {
    this.edits.abort();
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
