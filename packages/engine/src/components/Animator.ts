import { AnimationMixer } from 'three';
import type { Scene } from '../core/SceneGraph';
import { component } from '../fields/component';
import { asset, number, string } from '../fields/fields';

/**
 * Plays a clip of a model on the objects below, which it finds by their names: those that a model was unpacked into. While
 * the scene is at its beginning, they are where they were put.
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
  static override readonly unique: boolean = true;
  static override readonly help: string = 'Plays a clip of a model on the objects below.';

  private mixer: AnimationMixer | null = null;

  /** Names of the clips that the model has; empty before it is loaded. */
  get animations(): string[] {
    const { scene, model } = this;
    if (!scene || model === null || !scene.assets.isReady('model', model)) return [];
    return scene.assets.model(model).animations.map(({ name }) => name);
  }

  override onEnterScene(scene: Scene): void {
    // the library tells of a model that cannot be loaded
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
    else this.startMixer()?.setTime(time * this.animationSpeed);
  }

  private startMixer(): AnimationMixer | null {
    if (this.mixer) return this.mixer;
    const { scene, model, animation } = this;
    if (!scene || model === null || animation === '' || !scene.assets.isReady('model', model)) return null;
    const clip = scene.assets.model(model).animations.find(({ name }) => name === animation);
    if (!clip) return null;
    this.mixer = new AnimationMixer(this.gameObject.object3D);
    this.mixer.clipAction(clip).play();
    return this.mixer;
  }

  private stop(): void {
    this.mixer?.stopAllAction();
    this.mixer?.uncacheRoot(this.mixer.getRoot());
    this.mixer = null;
  }
}
