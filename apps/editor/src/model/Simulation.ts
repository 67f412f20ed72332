import { Signal } from '@farol/editing';
import type { Scene } from '@farol/engine';

export type SimulationState = 'stopped' | 'playing' | 'paused';

/** Longest time step of a frame (s), so that the scene does not jump after the page was suspended. */
const LONGEST_STEP = 0.1;

/** Time step of `step` (s). */
const STEP = 1 / 60;

/** Plays, pauses and stops a scene. Stopping restores the scene as it was when it began to play. */
export class Simulation {
  /** Emits when the state changes, and after each `step`. */
  readonly changed = new Signal();

  private current: SimulationState = 'stopped';

  /** @param getScene - returns the document's scene @param edits - receives edits made while playing */
  constructor(
    private readonly getScene: () => Scene,
    private readonly edits: { begin(): void; end(reset: () => void): void; dismiss(): void },
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

  /** Freezes the scene at the current time. */
  pause(): void {
    if (!this.isPlaying) return;
    this.getScene().pause();
    this.enter('paused');
  }

  /** Advances a paused or stopped scene by one sixtieth of a second. */
  step(): void {
    if (this.isPlaying) return this.pause();
    if (this.current === 'stopped') this.edits.begin();
    this.getScene().update(STEP);
    this.getScene().pause();
    this.current = 'paused';
    this.changed.emit();
  }

  /** Sets time to 0 and the scene to what it was when it began to play. `PlayEdits` holds the edits made meanwhile. */
  stop(): void {
    if (this.current === 'stopped') return;
    this.edits.end(() => this.getScene().reset());
    this.enter('stopped');
  }

  /** Called when another scene was opened: stops without restoring anything. */
  restart(): void {
    this.edits.dismiss();
    this.enter('stopped');
  }

  /** Called each frame. @param deltaSeconds - time since the last frame; limited to 0.1 s */
  advance(deltaSeconds: number): void {
    if (this.isPlaying) this.getScene().update(Math.min(Math.max(deltaSeconds, 0), LONGEST_STEP));
  }

  private enter(state: SimulationState): void {
    if (state === this.current) return;
    this.current = state;
    this.changed.emit();
  }
}
