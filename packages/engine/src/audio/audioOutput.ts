import { Signal } from '@farol/editing';

/** Audio output of the page, which browsers block until the user's first press. */
class AudioOutput {
  private isMuted = false;
  private isHeldBack = false;
  private readonly changed = new Signal();

  /** Whether all sounds of all scenes are muted; they continue silently. */
  get muted(): boolean {
    return this.isMuted;
  }

  set muted(muted: boolean) {
    if (muted === this.isMuted) return;
    this.isMuted = muted;
    this.changed.emit();
  }

  /** Whether a sound is blocked until the user's first press. */
  get isWaiting(): boolean {
    return this.isHeldBack;
  }

  /** Calls `listener` when `muted` or `isWaiting` changes. @returns a function that removes the listener */
  readonly onChange = this.changed.subscribe;

  /**
   * @internal Whether an AudioContext may be made and heard; if not yet, waits for the user's first press.
   * @param context - the present context
   */
  mayBeHeard(context: BaseAudioContext | null): boolean {
    if (typeof AudioContext === 'undefined') return false;
    // browsers log a warning for a context made before the user's first press
    const mayBeHeard = globalThis.navigator?.userActivation?.hasBeenActive ?? true;
    this.hold(!mayBeHeard && context?.state !== 'running');
    return !this.isHeldBack;
  }

  private hold(isHeldBack: boolean): void {
    if (isHeldBack === this.isHeldBack) return;
    this.isHeldBack = isHeldBack;
    this.changed.emit();
  }
}

/** Audio output shared by all scenes of the page. */
export const audioOutput = new AudioOutput();
export type { AudioOutput };
