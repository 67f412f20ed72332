import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';
import type { ClipData } from '../assets/clips/ClipData';
import { trackTarget } from './trackTarget';
import { valueAt } from './valueAt';

/** Shows a clip at a time on an object tree, for scrubbing in a stopped scene: neither an edit nor saved. */
export class ClipPreview {
  private readonly previewed = new Map<Component, Set<string>>();

  /** @param gameObject - root of the tracks' paths */
  constructor(readonly gameObject: GameObject) {}

  /**
   * Shows the clip's values at a time; all other fields are shown as authored.
   * @param time - seconds from the beginning of the clip
   * @returns a message with its remedy for each track whose target is missing
   */
  show(clip: ClipData, time: number): string[] {
    const problems: string[] = [];
    const left = new Map<Component, Set<string>>();
    for (const [component, fields] of this.previewed) left.set(component, new Set(fields));
    for (const track of clip.tracks) {
      const { component, problem } = trackTarget(this.gameObject, track);
      if (!component) {
        problems.push(problem);
        continue;
      }
      const { field } = track;
      const value = valueAt(track, component.fields[field], time);
      if (value === undefined) continue;
      try {
        component.simulate(field, value);
      } catch (error) {
        problems.push((error as Error).message);
        continue;
      }
      left.get(component)?.delete(field);
      const fields = this.previewed.get(component);
      if (fields) fields.add(field);
      else this.previewed.set(component, new Set([field]));
    }
    for (const [component, fields] of left) {
      for (const field of fields) component.simulate(field, component.getAuthored(field));
    }
    return problems;
  }

  /** Ends the preview: all fields are shown as authored. */
  end(): void {
    for (const component of this.previewed.keys()) component.endSimulation();
    this.previewed.clear();
  }
}
