import type { ClipData, Component, GameObject } from '@farol/engine';
import { trackId, valueAt } from './clipTracks';
import { targetOf } from './trackTargets';

/** Shows an object as a clip has it at a time: no edit, and not saved. */
export class ClipPreview {
  /** What shows a value of the clip. */
  private shown = new Set<Component>();

  /** Whether anything shows a value of a clip. */
  get isShown(): boolean {
    return this.shown.size > 0;
  }

  /** Shows the values of all tracks at a time; what an earlier call showed and this one does not is as authored again. */
  show(root: GameObject, { tracks }: ClipData, time: number): void {
    const before = this.shown;
    this.shown = new Set();
    for (const track of tracks) {
      const target = track.keys.length > 0 ? targetOf(root, track) : null;
      if (!target) continue;
      this.shown.add(target);
      try {
        target.simulate(track.field, valueAt(track.keys, time));
      } catch (error) {
        this.failed(trackId(track), error);
      }
    }
    for (const component of before) if (!this.shown.has(component)) component.endSimulation();
  }

  /** Shows what was authored. */
  end(): void {
    for (const component of this.shown) component.endSimulation();
    this.shown.clear();
    this.told.clear();
  }

  /** Takes what a track's value could not be shown for, once for each track. */
  onError: (error: unknown) => void = () => {};

  private readonly told = new Set<string>();

  private failed(id: string, error: unknown): void {
    if (this.told.has(id)) return;
    this.told.add(id);
    this.onError(error);
  }
}
