import { component } from '@farol/engine/fields';
import { type AnimationClip, AnimationMixer, type Object3D } from 'three';

/** Plays an animation of a loaded model by the scene's time, in a loop. */
export class ModelAnimation extends component({}) {
  static override readonly typeName: string = 'ModelAnimation';

  private mixer: AnimationMixer | null = null;

  /** Plays a clip of the model from the scene's current time. */
  play(model: Object3D, clip: AnimationClip): this {
    this.mixer?.stopAllAction();
    this.mixer = new AnimationMixer(model);
    this.mixer.clipAction(clip).play();
    return this;
  }

  override update(_deltaSeconds: number, time: number): void {
    this.mixer?.setTime(time);
  }

  override dispose(): void {
    this.mixer?.stopAllAction();
  }
}
