import { asset, number, string } from '@farol/editing/fields';
import { LoopedClip } from '../animation/LoopedClip';
import type { Scene } from '../core/Scene';
import { component } from '../core/Component';

/**
 * Kept for older files; use `Animation`. Plays a model's clip on the objects that the model was unpacked into, found by
 * name below this one. At scene time 0 the objects keep their authored poses.
 */
export class Animator extends component({
  model: asset('model', null, { help: 'The model whose clips it plays.' }),
  animation: string('', {
    choices: 'animations',
    help: 'The clip that plays while the scene plays.',
    label: 'Clip',
  }),
  animationSpeed: number(1, { step: 0.1, help: 'Factor of the speed; below 0 it runs backwards.', label: 'Speed' }),
}) {
  static override readonly typeName: string = 'Animator';
  static override readonly icon: string = 'play';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Plays a clip of a model on the objects below.';

  private looped: LoopedClip | null = null;

  /** Names of the model's clips; empty until loaded. */
  get animations(): string[] {
    const { scene, model } = this;
    if (!scene || model === null || !scene.assets.isReady('model', model)) return [];
    return scene.assets.model(model).animations.map(({ name }) => name);
  }

  override onEnterScene(scene: Scene): void {
    // the error is ignored: the library reports a model that cannot be loaded
    if (this.model !== null && !scene.assets.isReady('model', this.model))
      void scene.assets.load(this.model).catch(() => {});
  }

  override onLeaveScene(): void {
    this.stop();
  }

  override onFieldChanged(name: string): void {
    if (name === 'animationSpeed') return;
    this.stop();
    if (name === 'model' && this.scene) this.onEnterScene(this.scene);
  }

  override onActiveChanged(): void {
    if (!this.isActive) this.stop();
  }

  override update(_deltaSeconds: number, time: number): void {
    if (time === 0) this.stop();
    else this.begin()?.show(time * this.animationSpeed);
  }

  private begin(): LoopedClip | null {
    if (this.looped) return this.looped;
    const { scene, model, animation } = this;
    if (!scene || model === null || animation === '' || !scene.assets.isReady('model', model)) return null;
    const clip = scene.assets.model(model).clips.find(({ name }) => name === animation);
    if (clip) this.looped = new LoopedClip(clip, this.gameObject, null);
    return this.looped;
  }

  private stop(): void {
    this.looped?.end();
    this.looped = null;
  }
}
