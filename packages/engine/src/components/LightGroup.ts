import { colour, number } from '@farol/editing/fields';
import { component } from '../core/Component';
import type { NewObject } from '../core/NewObject';
import type { Scene } from '../core/Scene';
import { LightGroups } from './lightGroups';

/**
 * Master of the lights whose `group` is the component's object: multiplies their intensities and colours without
 * changing their fields; lights of particles are only dimmed. While the component or its object is switched off, the
 * lights are dark. Timelines and scripts may animate its fields.
 */
export class LightGroup extends component({
  dimmer: number(1, {
    min: 0,
    max: 10,
    step: 0.01,
    help: 'Factor of the intensity of every light of the group; 0 is dark.',
  }),
  colour: colour([1, 1, 1], { help: 'Multiplies the colour of every light of the group.' }),
}) {
  static override readonly typeName: string = 'LightGroup';
  static override readonly icon: string = 'sliders';
  static override readonly unique: boolean = true;
  static override readonly help: string =
    'Dims and tints all lights that name this object as their group; they are dark while it is off.';

  static override readonly newObjects: readonly NewObject[] = [{ label: 'Light group', group: 'light' }];

  override onEnterScene(): void {
    this.tell();
  }

  override onLeaveScene(scene: Scene): void {
    LightGroups.of(scene).setMaster(this.gameObject.id, null);
  }

  override onFieldChanged(): void {
    this.tell();
  }

  override onActiveChanged(): void {
    this.tell();
  }

  private tell(): void {
    const { scene, gameObject, dimmer, colour: tint } = this;
    if (scene) LightGroups.of(scene).setMaster(gameObject.id, { dimmer: this.isActive ? dimmer : 0, colour: tint });
  }
}
