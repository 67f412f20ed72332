import type { AnimationClip } from 'three';
import type { Model } from './Model';

/** A clip that came with a model: part of it in a library, 'robot.glb/clip-1-Walk'. Its tracks name nodes of the model. */
export class ModelClip {
  readonly isModelClip = true;

  constructor(
    readonly three: AnimationClip,
    readonly model: Model,
  ) {}

  /** As the file calls it. */
  get name(): string {
    return this.three.name;
  }

  /** Seconds. */
  get duration(): number {
    return this.three.duration;
  }

  dispose(): void {}
}
