import { component } from '@farol/engine/fields';
import { type AnimationClip, AnimationMixer, type Object3D } from 'three';

/** Plays an animation of a loaded model in step with the scene's time, over and over. */
export class ModelAnimation extends component({}) {
  static override readonly typeName: string = 'ModelAnimation';

  private mixer: AnimationMixer | null = null;

  /** Plays a clip of the model from now on. */
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
